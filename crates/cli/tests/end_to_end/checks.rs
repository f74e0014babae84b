use crate::workbench::{ROOM, Workbench};

#[test]
fn check_says_what_a_file_is_and_what_is_in_it() {
    let bench = Workbench::new();
    bench.cogmap("run room.world.json --out drive").done();
    bench.cogmap("replay walk.log --out log").done();
    let files = "room.world.json walk.log drive/session.json log/session.json";
    let outcome = bench.cogmap(&format!("check {files}")).done();
    for phrase in ["world", "across", "24 scans", "session", "consensus"] {
        assert!(outcome.out.contains(phrase), "{phrase}: {}", outcome.out);
    }
}

#[test]
fn check_goes_through_all_files_and_fails_if_one_is_bad() {
    let bench = Workbench::new();
    bench.put("bad.world.json", ROOM.replace("\"walls\"", "\"wals\""));
    bench.put("walled-in.world.json", ROOM.replace("[5,2.4]", "[50,2.4]"));
    let outcome = bench.cogmap("check bad.world.json walled-in.world.json none.log room.world.json");
    assert_eq!(outcome.code, Some(2));
    for phrase in ["did you mean `walls`?", "`routes.across[1]`", "none.log"] {
        assert!(outcome.err.contains(phrase), "{phrase}: {outcome:#?}");
    }
    assert!(outcome.out.contains("room.world.json"), "{outcome:#?}");
}

#[test]
fn check_notes_what_is_hardly_meant_and_takes_the_file_all_the_same() {
    let bench = Workbench::new();
    let narrow = r#""doors": [{"name": "cat", "hinge": [1,0.5], "latch": [1.2,0.5]}], "walls""#;
    bench.put("narrow.world.json", ROOM.replace("\"walls\"", narrow));
    let outcome = bench.cogmap("check narrow.world.json").done();
    assert!(outcome.err.contains("note: narrow.world.json, at `doors[0]`: is 0.20 m wide"), "{outcome:#?}");
    assert!(outcome.out.contains("a world"), "{outcome:#?}");
}
