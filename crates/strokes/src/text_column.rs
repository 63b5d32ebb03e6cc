/// A column of text.
///
/// All cells share one string: a column of a million short cells is two allocations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextColumn {
    name: String,
    text: String,
    /// End of each cell in `text`.
    ends: Vec<usize>,
}

impl TextColumn {
    pub(crate) fn new(name: &str) -> Self {
        Self { name: name.into(), text: String::new(), ends: Vec::new() }
    }

    pub(crate) fn push(&mut self, cell: &str) {
        self.text.push_str(cell);
        self.ends.push(self.text.len());
    }

    /// Name in the header.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Text in a row, counted from 0; `None` after the last row.
    #[must_use]
    pub fn cell(&self, row: usize) -> Option<&str> {
        let start = match row.checked_sub(1) {
            None => 0,
            Some(before) => *self.ends.get(before)?,
        };
        self.text.get(start..*self.ends.get(row)?)
    }
}
