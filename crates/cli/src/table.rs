/// A table for a terminal or a text file: the first column is for words, the others for numbers.
#[derive(Debug)]
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
    /// Whether all columns are for words.
    words: bool,
}

impl Table {
    /// A table with nothing under its heads.
    pub(crate) fn new(heads: &[&str]) -> Self {
        Self { rows: vec![heads.iter().map(|&head| head.to_owned()).collect()], words: false }
    }

    /// A table all of whose columns are for words.
    pub(crate) fn of_words(heads: &[&str]) -> Self {
        Self { words: true, ..Self::new(heads) }
    }

    /// Adds a row; a cell for each head.
    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The lines, each indented by two spaces.
    pub(crate) fn render(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(|column| self.width(column)).collect();
        self.rows.iter().map(|row| line(row, &widths, self.words)).collect()
    }

    fn width(&self, column: usize) -> usize {
        self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    }
}

fn line(row: &[String], widths: &[usize], words: bool) -> String {
    let mut line = String::new();
    for (column, (cell, &width)) in row.iter().zip(widths).enumerate() {
        line += "  ";
        line += &if column == 0 || words { format!("{cell:<width$}") } else { format!("{cell:>width$}") };
    }
    line.trim_end().to_owned() + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_left_and_numbers_right() {
        let mut table = Table::new(&["mapper", "views"]);
        table.row(vec!["perceptual".into(), "7".into()]);
        table.row(vec!["odometry".into(), "1200".into()]);
        assert_eq!(table.render(), "  mapper      views\n  perceptual      7\n  odometry     1200\n");
    }
}
