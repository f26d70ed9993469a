//! `brinell completions`: what a shell needs to complete commands, options and their values.

use super::status::{CommandResult, ExitStatus};
use clap::{Args, Command, ValueEnum};
use clap_complete::{Shell, generate};
use std::io::Write;

/// A shell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ShellName {
    Bash,
    Zsh,
    Fish,
}

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  brinell completions bash > ~/.local/share/bash-completion/completions/brinell
  brinell completions zsh > ~/.zfunc/_brinell     # with fpath+=(~/.zfunc) before compinit
  brinell completions fish > ~/.config/fish/completions/brinell.fish")]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: ShellName,
}

/// Prints the script for `command`, the whole command line.
pub fn run(args: &CompletionsArgs, command: &mut Command) -> CommandResult {
    let shell = match args.shell {
        ShellName::Bash => Shell::Bash,
        ShellName::Zsh => Shell::Zsh,
        ShellName::Fish => Shell::Fish,
    };
    let mut script = Vec::new();
    generate(shell, command, "brinell", &mut script);
    // A reader that has gone, such as `head`, stops nothing.
    let _ = std::io::stdout().write_all(&script);
    Ok(ExitStatus::Done)
}
