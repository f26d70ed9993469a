//! The page of a bearing answers every item of the checker's list in the book.

use brinell::case;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::msh::write::msh41;
use brinell::product::job::{self, Options};
use brinell::solver::solve::Silent;
use std::path::Path;

/// An item of the list: its number, who asks, where the answer is, and what answers.
struct Item {
    number: usize,
    who: String,
    section: String,
    answer: String,
}

fn items(list: &str) -> Vec<Item> {
    let rows = list.lines().filter_map(|line| {
        let cells: Vec<&str> = line
            .trim()
            .trim_matches('|')
            .split('|')
            .map(str::trim)
            .collect();
        let [number, _, who, section, answer] = cells[..] else {
            return None;
        };
        Some(Item {
            number: number.parse().ok()?,
            who: who.to_owned(),
            section: section.trim_matches('`').to_owned(),
            answer: answer.to_owned(),
        })
    });
    rows.collect()
}

/// The markup of a section of the page.
fn section<'p>(page: &'p str, id: &str) -> Option<&'p str> {
    let start = page.find(&format!("<section id=\"{id}\">"))?;
    let rest = &page[start..];
    Some(&rest[..rest.find("</section>")?])
}

#[test]
fn the_page_of_a_bearing_answers_every_item() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = std::fs::read_to_string(root.join("docs/book/reference/checklist.md")).unwrap();
    let items = items(&list);
    assert!(items.len() >= 40, "{}", items.len());
    assert!(
        items
            .iter()
            .zip(1..)
            .all(|(item, number)| item.number == number)
    );
    // Every guideline is named, and asks for something.
    for item in &items {
        for letter in item.who.split_whitespace() {
            assert!(list.contains(&format!("| {letter} | ")), "{letter}");
        }
    }
    let path = root.join("cases/section-2.6.2/initial-centre.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let text = format!(
        "{text}\n[title_block]\nproject = \"a bridge\"\nrevision = \"B\"\nprepared = \"N. N.\"\n"
    );
    let mut case = case::parse(&path.display().to_string(), &text).unwrap();
    case.set_preset("report-like").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let options = Options {
        out: Some(folder.path().to_owned()),
        elastic_peaks: true,
        report: true,
        ..Options::default()
    };
    job::run(&case, &options, &mut Silent).unwrap();
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    let missing: Vec<String> = items
        .iter()
        .filter(|item| {
            !section(&page, &item.section).is_some_and(|text| text.contains(&item.answer))
        })
        .map(|item| {
            format!(
                "{}: `{}` in section `{}`",
                item.number, item.answer, item.section
            )
        })
        .collect();
    assert!(
        missing.is_empty(),
        "the page does not answer\n{}",
        missing.join("\n")
    );
}

/// A plane that is turned by an angle and bears a moment: both stand in the tables of the model.
#[test]
fn moments_and_rotations_are_listed() {
    let scene = r#"
units = "mm-N-MPa"
mesh.file = "block.msh"
[steel]
youngs_modulus = 210000
poissons_ratio = 0.3
elastic = true
[[support]]
surface = "z_min"
fixed = "xyz"
[[rigid_plane]]
surface = "z_max"
force = { z = -10 }
fixed = "xy"
turns = "x"
moment = { x = 3 }
rotation = { z = "1 mrad" }
"#;
    let folder = tempfile::tempdir().unwrap();
    let side = || uniform(0.0, 1.0, 2);
    let block = Block::new("block", side(), side(), side()).build().unwrap();
    std::fs::write(folder.path().join("block.msh"), msh41(&block)).unwrap();
    let path = folder.path().join("case.toml");
    let case = case::parse(&path.display().to_string(), scene).unwrap();
    let options = Options {
        out: Some(folder.path().join("out")),
        report: true,
        ..Options::default()
    };
    job::run(&case, &options, &mut Silent).unwrap();
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    let model = section(&page, "model").unwrap();
    assert!(model.contains("turned about z by 0.001000 rad"), "{model}");
    assert!(model.contains("3.0000 N mm about x"), "{model}");
}
