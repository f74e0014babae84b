use std::fs::File;
use std::io::Read;
use std::path::Path;

use cogmap_formats::Kind;

use crate::failure::Failure;

/// No file that Cogmap reads is larger, bytes; what claims to be is not worth its memory.
const LARGEST: u64 = 1 << 30;

/// A file in memory.
#[derive(Debug)]
pub(crate) struct Input {
    /// Where it was found, for messages.
    pub(crate) name: String,
    /// What it holds, as it is on disk.
    pub(crate) bytes: Vec<u8>,
    /// The same without gzip's wrapping.
    pub(crate) plain: Vec<u8>,
}

impl Input {
    /// Reads a file and unwraps it.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let bytes = read_whole(path)?;
        let name = path.display().to_string();
        let plain = cogmap_formats::gzip::unpack(&bytes, &name).map_err(Failure::from)?.into_owned();
        Ok(Self { name, bytes, plain })
    }

    /// What it is.
    pub(crate) fn kind(&self) -> Kind {
        Kind::of(&self.plain)
    }

    /// Its content as text.
    pub(crate) fn text(&self) -> Result<&str, Failure> {
        std::str::from_utf8(&self.plain).map_err(|error| {
            Failure::input(format!("{}: byte {} is not UTF-8 text", self.name, error.valid_up_to() + 1))
                .help("save the file as UTF-8")
        })
    }
}

/// Reads a whole file, unless it is absurdly large.
fn read_whole(path: &Path) -> Result<Vec<u8>, Failure> {
    if path.is_dir() {
        return Err(
            Failure::input(format!("{}: this is a directory", path.display())).help("name a file in it")
        );
    }
    let unreadable = |error| Failure::unreadable(path, &error).help("check the name and its rights");
    let mut bytes = Vec::new();
    File::open(path).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes)).map_err(unreadable)?;
    if bytes.len() as u64 > LARGEST {
        return Err(Failure::input(format!("{}: larger than 1 GiB", path.display()))
            .help("split it; no log or world of a building needs that much"));
    }
    Ok(bytes)
}
