use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use cogmap_geometry::{DVec2, Pose};

/// A directory that the program runs in, with `room.world.json` and `walk.log`.
pub(crate) struct Workbench {
    place: tempfile::TempDir,
}

/// How the program ended and what it said.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// A room of 6 m by 4 m with a cupboard and a table, and one way through it.
pub(crate) const ROOM: &str = r#"{
  "format": "cogmap-world/1", "name": "Room",
  "walls": [[[0,0],[6,0],[6,4],[0,4],[0,0]]],
  "boxes": [{"center":[3,3.6], "size":[1.2,0.6]}, {"center":[4.6,0.4], "size":[0.8,0.5]}],
  "start": {"position":[1,1], "heading_deg":0},
  "routes": {"across": [[3,1.6],[5,2.4]], "back": [[2,2],[1,3]]}
}"#;

impl Workbench {
    pub(crate) fn new() -> Self {
        let bench = Self { place: tempfile::tempdir().unwrap() };
        bench.put("room.world.json", ROOM);
        bench.put("walk.log", walk());
        bench
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.place.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Runs the program here; the arguments are separated by spaces.
    pub(crate) fn cogmap(&self, arguments: &str) -> Outcome {
        self.cogmap_with(arguments.split_whitespace())
    }

    pub(crate) fn cogmap_with<S: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Outcome {
        let output = self.command().args(arguments).output().unwrap();
        Outcome {
            code: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// The program with the workbench as its working directory.
    pub(crate) fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cogmap"));
        command.current_dir(self.place.path()).stdin(Stdio::null());
        command
    }

    /// The program's files of a run, by name.
    pub(crate) fn files_in(&self, directory: &str) -> Vec<(String, Vec<u8>)> {
        let mut files: Vec<_> = fs::read_dir(self.path(directory))
            .unwrap()
            .map(|entry| {
                let path = entry.unwrap().path();
                (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(&path).unwrap())
            })
            .collect();
        files.sort();
        files
    }
}

impl Outcome {
    /// The same, after making sure that the command was done.
    pub(crate) fn done(self) -> Self {
        assert_eq!(self.code, Some(0), "{}{}", self.out, self.err);
        self
    }
}

/// A recorded walk of 24 scans through an empty room of 8 m by 6 m, as a CARMEN log.
pub(crate) fn walk() -> String {
    let mut log = String::from("# a made-up walk\nPARAM robot_front_laser_max 81.9\n");
    for step in 0..24 {
        let along = f64::from(step) * 0.2;
        let robot = Pose::new(1.0 + along, 1.5 + 0.3 * along, 0.3);
        let t = f64::from(step) * 0.5;
        let ranges: Vec<String> = (0..181)
            .map(|beam| format!("{:.3}", range(robot, (f64::from(beam) - 90.0).to_radians())))
            .collect();
        let pose = format!("{:.4} {:.4} {:.4}", robot.position.x, robot.position.y, robot.heading);
        log += &format!("ODOM {pose} 0.4 0 0 {t:.3} robot {t:.3}\n");
        log += &format!("FLASER 181 {} {pose} {pose} {t:.3} robot {t:.3}\n", ranges.join(" "));
    }
    log
}

/// How far it is to the walls of the empty room, metres.
fn range(robot: Pose, bearing: f64) -> f64 {
    let ray = robot.rotate(Pose::new(0.0, 0.0, bearing).forward());
    let room = DVec2::new(8.0, 6.0);
    let far = DVec2::select(ray.cmpge(DVec2::ZERO), room, DVec2::ZERO);
    ((far - robot.position) / ray).min_element()
}

/// The project's root.
pub(crate) fn project() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}
