//! `docs/operations.md`: its settings are those of the program, by name, variable and default.

use std::collections::BTreeMap;
use std::process::Command;

use clap::Parser;
use terramechanics_server::config::Config;

use super::{quoted, table};
use crate::running::PROGRAM;

const TEXT: &str = include_str!("../../../docs/operations.md");

/// Defaults that are not one value on every machine.
const ONE_PER_CORE: &str = "one per core";
const HALF: &str = "half of `--max-connections`";

/// What `--help` says of an option: its variable, and its default where it has one.
fn options() -> BTreeMap<String, (String, Option<String>)> {
    let output = Command::new(PROGRAM).arg("--help").output().expect("the program runs");
    let help = String::from_utf8(output.stdout).expect("text");
    let within = |text: &str, opening: &str, closing: char| {
        text.split_once(opening).and_then(|(_, rest)| rest.split_once(closing)).map(|(value, _)| value.to_owned())
    };
    let described = |option: &str| {
        let name = option.split([' ', '\n']).next().expect("a name");
        let variable = within(option, "[env: ", '=').unwrap_or_else(|| panic!("--{name} has no variable"));
        (format!("--{name}"), (variable, within(option, "[default: ", ']')))
    };
    help.split("\n      --").skip(1).map(described).collect()
}

#[test]
fn the_table_of_settings_has_every_option_of_the_program_with_its_default() {
    let options = options();
    let rows = table(TEXT, "## Settings");
    let flags: Vec<&str> = rows.iter().flat_map(|row| quoted(row[0])).collect();
    let missing: Vec<&String> = options.keys().filter(|flag| !flags.contains(&flag.as_str())).collect();
    assert!(missing.is_empty(), "the table lacks {missing:?}");
    assert_eq!(rows.len(), options.len(), "the table has a setting that the program has not, or has one twice");
    for row in rows {
        let [flag, variable, default] = [row[0], row[1], row[2]];
        let (known_variable, known_default) =
            options.get(flag.trim_matches('`')).unwrap_or_else(|| panic!("the program has no {flag}"));
        assert_eq!(variable, format!("`{known_variable}`"), "{flag}");
        match known_default {
            Some(value) if default == ONE_PER_CORE => {
                let cores = std::thread::available_parallelism().map_or(1, usize::from);
                assert_eq!(*value, cores.to_string(), "{flag}");
            }
            Some(value) => assert_eq!(default, format!("`{value}`"), "{flag}"),
            None => {
                let known = [("`--max-connections-per-peer`", HALF), ("`--public-url`", "none"), ("`--cors-origin`", "none")];
                assert!(known.contains(&(flag, default)), "{flag}");
            }
        }
    }
}

#[test]
fn one_address_may_have_half_of_the_connections() {
    let config = Config::try_parse_from(["terramechanics", "--max-connections", "100"]).expect("settings");
    assert_eq!(config.serve.bounds().of_one_peer, 50);
}
