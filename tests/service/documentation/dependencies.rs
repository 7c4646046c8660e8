//! `docs/dependencies.md` names every direct dependency, and no other.

use std::collections::BTreeSet;

use super::{quoted, root};

/// The names in the tables of dependencies of a manifest, without crates of the project.
fn dependencies(manifest: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut is_table = false;
    for line in manifest.lines() {
        if line.starts_with('[') {
            is_table = line.ends_with("dependencies]");
        } else if let (true, Some((name, _))) = (is_table, line.split_once(['=', '.', ' '])) {
            names.extend((!name.starts_with("terramechanics") && !name.starts_with('#')).then(|| name.to_owned()));
        }
    }
    names
}

#[test]
fn every_dependency_has_its_reason() {
    let crates = std::fs::read_dir(root().join("crates")).expect("the crates");
    let manifests = crates.map(|entry| entry.expect("an entry").path()).chain(["", "fuzz"].map(|path| root().join(path)));
    let used: BTreeSet<String> = manifests
        .flat_map(|folder| dependencies(&std::fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest")))
        .collect();
    let text = std::fs::read_to_string(root().join("docs/dependencies.md")).expect("the document");
    let rows = text.lines().filter(|line| line.starts_with("| `"));
    let told: BTreeSet<String> =
        rows.flat_map(|row| quoted(row.split('|').nth(1).unwrap_or("")).map(str::to_owned).collect::<Vec<_>>()).collect();
    assert!(used.len() > 30, "{used:?}");
    assert_eq!(told, used);
}
