use std::io;

use serde::Serialize;
use serde_json::ser::{CompactFormatter, Formatter, Serializer};

/// JSON in one fixed form: keys in the order of the types, one element a line down to `depth`, the
/// rest compact; shortest numbers that read back the same, and no negative zero.
pub(crate) fn write<T: Serialize>(value: &T, depth: usize) -> String {
    let mut bytes = Vec::new();
    let mut writer = Serializer::with_formatter(&mut bytes, Tidy { depth, level: 0, filled: false });
    match value.serialize(&mut writer) {
        Ok(()) => String::from_utf8_lossy(&bytes).into_owned(),
        // Only a map whose keys are no strings could fail, and no file has one.
        Err(_) => String::new(),
    }
}

/// The same with the line's end that a text file has.
pub(crate) fn write_file<T: Serialize>(value: &T, depth: usize) -> String {
    write(value, depth) + "\n"
}

/// Lays JSON out: broken over lines down to a depth, compact below it.
struct Tidy {
    depth: usize,
    level: usize,
    filled: bool,
}

impl Tidy {
    fn open<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.level += 1;
        self.filled = false;
        writer.write_all(bracket)
    }

    fn close<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        if self.filled {
            self.break_line(writer, self.level - 1, self.level)?;
        }
        self.level -= 1;
        self.filled = true;
        writer.write_all(bracket)
    }

    fn element<W: ?Sized + io::Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        self.break_line(writer, self.level, self.level)
    }

    fn break_line<W: ?Sized + io::Write>(
        &self,
        writer: &mut W,
        indent: usize,
        level: usize,
    ) -> io::Result<()> {
        if level > self.depth {
            return Ok(());
        }
        writer.write_all(b"\n")?;
        (0..indent).try_for_each(|_| writer.write_all(b"  "))
    }
}

impl Formatter for Tidy {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        CompactFormatter.write_f64(writer, value + 0.0)
    }

    fn begin_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"[")
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]")
    }

    fn begin_array_value<W: ?Sized + io::Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.element(writer, first)
    }

    fn end_array_value<W: ?Sized + io::Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}")
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.element(writer, first)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(if self.level > self.depth { b":" } else { b": " })
    }

    fn end_object_value<W: ?Sized + io::Write>(&mut self, _: &mut W) -> io::Result<()> {
        self.filled = true;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_stops_at_the_depth_and_negative_zero_is_zero() {
        let value = serde_json::json!({"a": [[-0.0, 1.5], []], "b": {}});
        assert_eq!(write(&value, 0), r#"{"a":[[0.0,1.5],[]],"b":{}}"#);
        assert_eq!(write(&value, 2), "{\n  \"a\": [\n    [0.0,1.5],\n    []\n  ],\n  \"b\": {}\n}");
    }
}
