//! Fenced blocks of a Markdown page.

/// A fenced block.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// The words after the fence: the language, then what the tests go by.
    pub info: Vec<String>,
    /// Line of the fence, from 1.
    pub line: usize,
    pub text: String,
}

impl Block {
    pub fn language(&self) -> &str {
        self.info.first().map_or("", String::as_str)
    }

    /// Is `word` among the words after the language?
    pub fn is(&self, word: &str) -> bool {
        self.info.iter().skip(1).any(|w| w == word)
    }
}

/// The fenced blocks of `page`, in their order.
pub fn blocks(page: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    for (index, line) in page.lines().enumerate() {
        match (line.trim_start().strip_prefix("```"), open) {
            (Some(_), true) => open = false,
            (Some(info), false) => {
                open = true;
                blocks.push(Block {
                    info: info.split_whitespace().map(str::to_string).collect(),
                    line: index + 1,
                    text: String::new(),
                });
            }
            (None, true) => {
                let block = blocks.last_mut().unwrap();
                block.text.push_str(line);
                block.text.push('\n');
            }
            (None, false) => {}
        }
    }
    assert!(!open, "a fence is not closed");
    blocks
}

#[test]
fn blocks_are_found_with_their_words() {
    let page = "a\n```sh slow\nls\n```\nb\n```toml case.toml\nx = 1\ny = 2\n```\n";
    let found = blocks(page);
    assert_eq!(found.len(), 2);
    assert!(found[0].language() == "sh" && found[0].is("slow") && found[0].line == 2);
    assert!(found[1].is("case.toml") && found[1].text == "x = 1\ny = 2\n");
}
