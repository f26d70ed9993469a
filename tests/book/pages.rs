//! The pages: reference made from the code, contents complete, links that lead somewhere.

use brinell::render::summary;
use brinell::{case, cli};
use std::path::{Path, PathBuf};

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A page by its path from the root of the repository.
pub fn read(page: &str) -> String {
    std::fs::read_to_string(root().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"))
}

const BOOK: &str = "docs/book";

/// The tutorials, in their order.
pub fn tutorials() -> Vec<String> {
    pages()
        .into_iter()
        .filter(|page| page.contains("/tutorials/"))
        .collect()
}

/// Every page of the book.
fn pages() -> Vec<String> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => walk(&path, found),
                false => found.push(path),
            }
        }
    }
    let mut found = Vec::new();
    walk(&root().join(BOOK), &mut found);
    found.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    let from_root = |path: PathBuf| path.strip_prefix(root()).unwrap().display().to_string();
    let mut pages: Vec<String> = found.into_iter().map(from_root).collect();
    pages.sort();
    pages
}

#[test]
fn the_reference_is_what_the_code_says() {
    for (page, made) in [
        ("docs/book/reference/case.md", case::keys::page()),
        ("docs/book/reference/commands.md", cli::reference::page()),
        (
            "docs/book/reference/steels.md",
            case::grades::page().unwrap(),
        ),
    ] {
        let help = "`cargo run --release --example reference` writes it anew";
        assert!(
            read(page) == made,
            "{page} is not what the code says: {help}"
        );
    }
}

#[test]
fn the_schemas_are_what_the_code_says() {
    let help = "`cargo run --release --example reference` writes it anew";
    for (file, made) in [
        ("docs/schema/case.schema.json", case::keys::schema::schema()),
        ("docs/schema/summary.schema.json", summary::schema()),
    ] {
        let there: serde_json::Value = serde_json::from_str(&read(file)).unwrap();
        assert!(there == made, "{file} is not what the code says: {help}");
    }
    let strange = case::keys::schema::not_understood();
    let help = "`src/case/keys/schema.rs` turns what a key takes into its type: say it in words that it knows, or teach it";
    assert!(strange.is_empty(), "{help}:\n{}", strange.join("\n"));
}

#[test]
fn the_contents_list_every_page_once() {
    let contents = read("docs/book/SUMMARY.md");
    for page in pages().iter().filter(|page| !page.ends_with("SUMMARY.md")) {
        let link = format!("({})", page.strip_prefix("docs/book/").unwrap());
        assert_eq!(contents.matches(&link).count(), 1, "{page}");
    }
}

#[test]
fn links_lead_to_files_and_headings() {
    let mut wrong = Vec::new();
    let documents = ["README.md", "ARCHITECTURE.md"].map(str::to_string);
    for page in pages().into_iter().chain(documents) {
        let folder = root().join(&page);
        let folder = folder.parent().unwrap();
        for link in links(&read(&page)) {
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let file = match file {
                "" => root().join(&page),
                file => folder.join(file),
            };
            let markdown = file.extension().is_some_and(|ending| ending == "md");
            let there = file.exists()
                && (heading.is_empty()
                    || !markdown
                    || headings(&file).contains(&heading.to_string()));
            if !there {
                wrong.push(format!("{page}: {link}"));
            }
        }
    }
    assert!(wrong.is_empty(), "lead nowhere:\n{}", wrong.join("\n"));
}

/// Targets of the links of a page that are no addresses of the web.
fn links(page: &str) -> Vec<String> {
    let starts = page
        .match_indices("](")
        .map(|(at, found)| &page[at + found.len()..]);
    let targets = starts
        .filter_map(|rest| rest.split_once(')'))
        .map(|(target, _)| target);
    let local = targets.filter(|t| !t.starts_with("http") && !t.contains(char::is_whitespace));
    local.map(str::to_string).collect()
}

/// The anchors of a page's headings, as forges and mdBook make them.
fn headings(page: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(page).unwrap();
    let headings = text.lines().filter(|line| line.starts_with('#'));
    let anchor = |line: &str| -> String {
        let words = line.trim_start_matches('#').trim().to_lowercase();
        let kept = words
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    headings.map(anchor).collect()
}
