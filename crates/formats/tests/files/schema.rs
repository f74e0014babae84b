use std::{env, fs, path::PathBuf};

use cogmap_formats::world;

/// Refreshed with `UPDATE_GOLDENS=1`.
#[test]
fn the_published_schema_is_that_of_the_types() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../worlds/cogmap-world.schema.json");
    let schema = world::schema();
    if env::var_os("UPDATE_GOLDENS").is_some() {
        fs::write(&path, &schema).unwrap();
    }
    let published = fs::read_to_string(&path).unwrap_or_default();
    assert!(published == schema, "worlds/cogmap-world.schema.json is not what the types say");
}

#[test]
fn the_schema_knows_required_keys_and_refuses_others() {
    let schema: serde_json::Value = serde_json::from_str(&world::schema()).unwrap();
    assert_eq!(schema["additionalProperties"], false);
    assert_eq!(schema["required"], serde_json::json!(["format", "name", "start"]));
    assert_eq!(schema["properties"]["format"]["const"], "cogmap-world/1");
    assert!(schema["properties"]["walls"]["description"].is_string());
}
