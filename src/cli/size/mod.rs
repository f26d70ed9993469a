//! `brinell size`: from load, steel and displacement to a bearing, and a verdict on it.

mod args;
mod crossed;
mod line;
mod verdict;

use crate::cli::status::CommandResult;
pub use args::SizeArgs;
use args::TemplateName;

/// Carries out the command.
pub fn run(args: &SizeArgs) -> CommandResult {
    match args.template {
        TemplateName::Crossed => crossed::run(args),
        TemplateName::Line => line::run(args),
    }
}
