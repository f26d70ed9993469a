//! The help of the program as a whole: commands in groups, examples at the end.

use clap::Command;

/// At the end of `brinell --help`.
pub const EXAMPLES: &str = "Examples:
  brinell check case.toml                 what a run will take, and what is wrong with the case
  brinell run case.toml                   solve it: verdict here, files in results/case
  brinell run case.toml --mesh h0125      the same on a finer mesh
  brinell hertz --diameter \"3 in\" --length \"8 in\" --load \"65 kip\" --yield \"100 ksi\"

`brinell help run` has the options of a command. The book: docs/book/README.md";

/// Commands by what they are for, those that are used first at the top.
const GROUPS: [(&str, &[&str]); 5] = [
    ("Begin", &["size", "init", "check", "mesh"]),
    ("Solve", &["run", "sweep"]),
    ("Hand over", &["report", "export"]),
    ("Trust", &["converge", "verify", "study", "hertz"]),
    ("Shell", &["completions", "help"]),
];

/// Headings with the commands that there are, each with the first line of its help.
pub fn grouped(command: &Command) -> String {
    let mut text = String::new();
    for (heading, names) in GROUPS {
        let there = names
            .iter()
            .filter_map(|name| command.find_subcommand(name));
        let lines = there.map(|command| {
            let about = command.get_about().map(ToString::to_string);
            format!(
                "  {:12} {}\n",
                command.get_name(),
                about.unwrap_or_default()
            )
        });
        text.push_str(&format!("{heading}:\n{}\n", lines.collect::<String>()));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::{Cli, command};
    use clap::CommandFactory;

    #[test]
    fn every_command_has_a_group() {
        let mut command = Cli::command();
        command.build();
        let help = grouped(&command);
        for sub in command.get_subcommands() {
            let line = format!("\n  {:12} ", sub.get_name());
            assert_eq!(help.matches(&line).count(), 1, "`{}`", sub.get_name());
        }
    }

    /// Walks all commands: nothing is left without a word of help.
    #[test]
    fn every_argument_is_described() {
        fn look(command: &Command) {
            let name = command.get_name();
            assert!(command.get_about().is_some(), "`{name}` has no help");
            for argument in command.get_arguments() {
                let id = argument.get_id();
                assert!(argument.get_help().is_some(), "`{name} {id}` has no help");
            }
            command.get_subcommands().for_each(look);
        }
        look(&command());
    }
}
