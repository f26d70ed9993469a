//! Writes the pages of the book and the JSON schemas that are made from the code: `cargo run --release --example reference`.

use brinell::render::summary;
use brinell::{case, cli};

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/book/reference");
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("case.md"), case::keys::page())?;
    let steels = case::grades::page().map_err(std::io::Error::other)?;
    std::fs::write(folder.join("steels.md"), steels)?;
    std::fs::write(folder.join("commands.md"), cli::reference::page())?;
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/schema");
    std::fs::create_dir_all(&folder)?;
    for (file, schema) in [
        ("case.schema.json", case::keys::schema::schema()),
        ("summary.schema.json", summary::schema()),
    ] {
        std::fs::write(folder.join(file), format!("{schema:#}\n"))?;
    }
    Ok(())
}
