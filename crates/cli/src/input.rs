use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::failure::Failure;

/// No file that Cogmap reads is larger, bytes; what claims to be is not worth its memory.
const LARGEST: u64 = 1 << 30;

/// What a file is, told by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `cogmap-world/1`.
    World,
    /// `cogmap-session/1`.
    Session,
    /// Text that is none of the others: taken for a CARMEN log, whose reader has the last word.
    Log,
    /// A PNG or PGM picture: perhaps a floor plan.
    Picture,
    /// A ROS `map_server` description of a floor plan.
    MapServer,
    /// Something that Cogmap cannot use, by its name for people.
    Other(&'static str),
}

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
        kind_of(&self.plain)
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

fn kind_of(plain: &[u8]) -> Kind {
    if plain.starts_with(b"\x89PNG")
        || matches!(plain, [b'P', b'2' | b'5', space, ..] if space.is_ascii_whitespace())
    {
        return Kind::Picture;
    }
    for (magic, name) in [
        (&b"\xff\xd8\xff"[..], "a JPEG picture"),
        (b"\x89MCAP", "an MCAP log"),
        (b"PK\x03\x04", "a ZIP archive"),
    ] {
        if plain.starts_with(magic) {
            return Kind::Other(name);
        }
    }
    if plain.contains(&0) {
        return Kind::Other("a binary file");
    }
    kind_of_text(String::from_utf8_lossy(plain).trim_start())
}

fn kind_of_text(text: &str) -> Kind {
    match text.as_bytes().first() {
        None => Kind::Other("an empty file"),
        Some(b'{' | b'[') => kind_of_json(text),
        Some(b'<') if text.contains("<svg") => Kind::Other("an SVG picture"),
        Some(b'<') => Kind::Other("an XML or HTML file"),
        _ if has_line(text, "image:") || has_line(text, "resolution:") => Kind::MapServer,
        _ if has_line(text, "define ") || has_line(text, "include ") => Kind::Other("a Stage world"),
        _ => Kind::Log,
    }
}

/// A broken file is what it wanted to be, so that its own reader says where it is broken.
fn kind_of_json(text: &str) -> Kind {
    match serde_json::from_str::<serde_json::Value>(text) {
        Ok(serde_json::Value::Object(object)) => match object.get("format").and_then(|f| f.as_str()) {
            Some(format) if format.starts_with("cogmap-session/") => Kind::Session,
            Some(format) if format.starts_with("cogmap-map/") => Kind::Other("a map that a run left"),
            Some(format) if format.starts_with("cogmap-report/") => Kind::Other("a report that a run left"),
            None if object.contains_key("source") && object.contains_key("mappers") => Kind::Session,
            _ => Kind::World,
        },
        Ok(_) => Kind::Other("a JSON list"),
        Err(_) if text.contains("cogmap-session/") => Kind::Session,
        Err(_) => Kind::World,
    }
}

fn has_line(text: &str, beginning: &str) -> bool {
    text.lines().take(200).any(|line| line.starts_with(beginning))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_known_by_its_content() {
        for (content, kind) in [
            (r#"{"format":"cogmap-world/1"}"#, Kind::World),
            (r#"{"format":"cogmap-session/1"}"#, Kind::Session),
            ("{\"format\":\"cogmap-session/1\",\n oops", Kind::Session),
            (r#"{"walls":[]}"#, Kind::World),
            ("[[0,0],[1,1]]", Kind::Other("a JSON list")),
            ("# a comment\nFLASER 1 2 0 0 0 0 0 0 1 h 1\n", Kind::Log),
            ("image: a.png\nresolution: 0.05\n", Kind::MapServer),
            ("# a plan\nimage: a.png\n", Kind::MapServer),
            ("P2 3 3 255\n", Kind::Picture),
            ("define sicklaser ranger ()\n", Kind::Other("a Stage world")),
            ("<?xml version='1.0'?><svg/>", Kind::Other("an SVG picture")),
            (" \n", Kind::Other("an empty file")),
        ] {
            assert_eq!(kind_of(content.as_bytes()), kind, "{content}");
        }
        assert_eq!(kind_of(b"\x89PNG\r\n"), Kind::Picture);
        assert_eq!(kind_of(b"\xfe\x00\x01"), Kind::Other("a binary file"));
    }
}
