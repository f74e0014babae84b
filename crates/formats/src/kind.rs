/// What a file is, told by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
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

impl Kind {
    /// Of plain content, that is without gzip's wrapping.
    #[must_use]
    pub fn of(plain: &[u8]) -> Self {
        if plain.starts_with(b"\x89PNG")
            || matches!(plain, [b'P', b'2' | b'5', space, ..] if space.is_ascii_whitespace())
        {
            return Self::Picture;
        }
        for (magic, name) in [
            (&b"\xff\xd8\xff"[..], "a JPEG picture"),
            (b"GIF8", "a GIF picture"),
            (b"RIFF", "a WebP picture or a sound"),
            (b"\x89MCAP", "an MCAP log"),
            (b"PK\x03\x04", "a ZIP archive"),
        ] {
            if plain.starts_with(magic) {
                return Self::Other(name);
            }
        }
        if plain.contains(&0) {
            return Self::Other("a binary file");
        }
        of_text(String::from_utf8_lossy(plain).trim_start())
    }
}

fn of_text(text: &str) -> Kind {
    match text.as_bytes().first() {
        None => Kind::Other("an empty file"),
        Some(b'{' | b'[') => of_json(text),
        Some(b'<') if text.contains("<svg") => Kind::Other("an SVG picture"),
        Some(b'<') => Kind::Other("an XML or HTML file"),
        _ if has_line(text, "image:") || has_line(text, "resolution:") => Kind::MapServer,
        _ if has_line(text, "define ") || has_line(text, "include ") => Kind::Other("a Stage world"),
        _ => Kind::Log,
    }
}

/// A broken file is what it wanted to be, so that its own reader says where it is broken.
fn of_json(text: &str) -> Kind {
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
            assert_eq!(Kind::of(content.as_bytes()), kind, "{content}");
        }
        assert_eq!(Kind::of(b"\x89PNG\r\n"), Kind::Picture);
        assert_eq!(Kind::of(b"\xfe\x00\x01"), Kind::Other("a binary file"));
    }
}
