//! World files, `NAME.world.json`: a building, the robot's start, routes and rooms.

use cogmap_simulation::{Problem, World};
use schemars::generate::SchemaSettings;

use crate::{
    FormatError,
    error::{Complaint, Place, tame},
    json::{self, Piece},
};

/// The format that this version reads and writes.
pub const WORLD_FORMAT: &str = "cogmap-world/1";

/// Reads a world and makes sure that it can be simulated. `file` is the name for messages.
///
/// ```
/// let text = r#"{"format": "cogmap-world/1", "name": "Closet", "wals": []}"#;
/// let error = cogmap_formats::world::read(text, "closet.world.json").unwrap_err().to_string();
/// assert!(error.starts_with("closet.world.json, line 1, column "), "{error}");
/// assert!(error.ends_with("unknown key `wals`; did you mean `walls`?"), "{error}");
/// ```
///
/// # Errors
/// [`FormatError`] with the place and the way out.
pub fn read(text: &str, file: &str) -> Result<World, FormatError> {
    let world = parse(text, file)?;
    complain(&Piece::whole(text, file), world.problems())?;
    Ok(world)
}

/// Reads a world as it is written, whether or not it can be simulated: for whoever goes on writing it.
///
/// # Errors
/// [`FormatError`] where the text is no world file.
pub fn parse(text: &str, file: &str) -> Result<World, FormatError> {
    let piece = Piece::whole(text, file);
    piece.expect_format(WORLD_FORMAT)?;
    piece.read()
}

/// The world as a file, each wall, box and room on a line of its own.
#[must_use]
pub fn write(world: &World) -> String {
    json::write_file(world, 2)
}

/// The JSON Schema of world files, for editors and other programs.
#[must_use]
pub fn schema() -> String {
    let mut schema = SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<World>();
    schema.insert("title".to_owned(), "Cogmap world".into());
    if let Some(format) = schema.pointer_mut("/properties/format").and_then(|it| it.as_object_mut()) {
        format.insert("const".to_owned(), WORLD_FORMAT.into());
    }
    json::write_file(&schema, 99)
}

/// Turns what cannot be simulated into an error that knows the lines.
pub(crate) fn complain(piece: &Piece<'_>, problems: Vec<Problem>) -> Result<(), FormatError> {
    if problems.is_empty() {
        return Ok(());
    }
    let complaint = |problem: Problem| {
        let place = piece.locate(&problem.place);
        Complaint { place, problem: tame(&problem.message) }
    };
    let complaints = problems.into_iter().map(complaint).collect();
    Err(FormatError::Problems { place: Place::file(piece.file), complaints })
}
