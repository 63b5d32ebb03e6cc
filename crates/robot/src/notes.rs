use crate::bounds::MOST_NOTES;

/// What was odd in a document, but harmless.
#[derive(Debug, Clone, Default)]
pub(crate) struct Notes {
    list: Vec<String>,
    more: usize,
}

impl Notes {
    /// Adds a note; its words are only made if it is kept.
    pub(crate) fn add(&mut self, words: impl FnOnce() -> String) {
        if self.list.len() < MOST_NOTES {
            self.list.push(words());
        } else {
            self.more += 1;
        }
    }

    /// All of them, and how many more there were.
    pub(crate) fn finish(mut self) -> Vec<String> {
        if self.more > 0 {
            self.list.push(format!("and {} more of the kind", self.more));
        }
        self.list
    }
}
