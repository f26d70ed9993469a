//! Whatever the text of a case file is: a case, or an error that can be shown.
#![no_main]

use brinell::case;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    match case::parse("fuzz.toml", text) {
        Ok(case) => drop(case.model()),
        Err(error) => drop(format!("{:?}", miette::Report::new(error))),
    }
});
