//! The page of the book about the commands, from the definitions that parse them.

use super::command;
use crate::ground::markdown::table;
use clap::builder::StyledStr;
use clap::{Arg, Command};

/// The page, in Markdown.
pub fn page() -> String {
    let mut command = command();
    command.build();
    let mut text = String::from(
        "# Commands\n\nMade from the program's own definitions by `cargo run --release --example \
         reference`; not edited by hand.\n\n",
    );
    let commands = || command.get_subcommands().filter(|c| c.get_name() != "help");
    for sub in commands() {
        let name = sub.get_name();
        text.push_str(&format!(
            "- [`brinell {name}`](#brinell-{name}): {}\n",
            about(sub)
        ));
    }
    text.push_str(
        "\nExit status: 0 done and converged, 1 solved but a claim or limit failed, 2 bad input, 3 not \
         converged, 130 interrupted.\n",
    );
    commands().for_each(|sub| describe(sub, &mut text));
    text
}

fn describe(command: &Command, text: &mut String) {
    let name = command.get_name();
    let usage = command.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ");
    text.push_str(&format!(
        "\n## brinell {name}\n\n{}.\n\n```text\n{usage}\n```\n\n",
        about(command)
    ));
    let described = command.get_arguments().filter(|argument| {
        let id = argument.get_id().as_str();
        id != "help" && !argument.is_hide_set()
    });
    let rows: Vec<[String; 3]> = described.map(row).collect();
    if !rows.is_empty() {
        text.push_str(&table(["argument", "default", "meaning"], rows));
    }
    if let Some(after) = command.get_after_help() {
        text.push_str(&format!("\n```text\n{after}\n```\n"));
    }
}

fn about(command: &Command) -> String {
    let about = command.get_about().map(StyledStr::to_string);
    about.unwrap_or_default().trim_end_matches('.').to_string()
}

/// A row of the table: what is written, what is taken where it is not, what it does.
fn row(argument: &Arg) -> [String; 3] {
    let help = argument.get_help().map(StyledStr::to_string);
    let help = help.unwrap_or_default();
    let (meaning, worded) = match help.split_once(" [default: ") {
        Some((meaning, rest)) => {
            let (default, after) = rest.split_once(']').unwrap_or((rest, ""));
            (format!("{meaning}{after}"), Some(default.to_string()))
        }
        None => (help, None),
    };
    let defaults = argument.get_default_values().iter();
    let defaults: Vec<String> = defaults
        .map(|v| format!("`{}`", v.to_string_lossy()))
        .collect();
    let flag = !argument.get_action().takes_values();
    let default = match (worded, defaults.is_empty()) {
        (Some(words), _) => words,
        (None, false) if !flag => defaults.join(", "),
        (None, _) if argument.is_required_set() => "required".to_string(),
        (None, _) => String::new(),
    };
    let values = argument.get_possible_values();
    let values: Vec<String> = (values.iter())
        .filter(|value| !flag && !value.is_hide_set())
        .map(|value| match value.get_help() {
            Some(help) => format!("`{}` ({help})", value.get_name()),
            None => format!("`{}`", value.get_name()),
        })
        .collect();
    let one_of = if values.is_empty() {
        String::new()
    } else {
        format!(" One of: {}.", values.join(", "))
    };
    [
        format!("`{}`", written(argument)),
        default,
        format!("{}{one_of}", ended(&meaning)),
    ]
}

/// The argument as it is typed.
fn written(argument: &Arg) -> String {
    let value = || {
        let names = argument.get_value_names().unwrap_or_default();
        names.first().map(ToString::to_string).unwrap_or_default()
    };
    match (argument.get_long(), argument.get_short()) {
        (None, None) => format!("<{}>", value()),
        (long, short) => {
            let short = short.map(|short| format!("-{short}"));
            let names = short
                .into_iter()
                .chain(long.map(|long| format!("--{long}")));
            let names: Vec<String> = names.collect();
            if argument.get_action().takes_values() {
                format!("{} <{}>", names.join(", "), value())
            } else {
                names.join(", ")
            }
        }
    }
}

fn ended(text: &str) -> String {
    match text.trim_end() {
        "" => String::new(),
        text if text.ends_with('.') => text.to_string(),
        text => format!("{text}."),
    }
}
