//! Links and paths in the README and the files in `docs/` lead somewhere.

use std::path::PathBuf;

use super::{quoted, root};

/// The README and every file in `docs/`, by path.
fn texts() -> Vec<(PathBuf, String)> {
    let docs = std::fs::read_dir(root().join("docs")).expect("docs").map(|entry| entry.expect("an entry").path());
    let paths = docs.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let all = [root().join("README.md")].into_iter().chain(paths);
    all.map(|path| (path.clone(), std::fs::read_to_string(&path).expect("text"))).collect()
}

/// The text without its code blocks.
fn prose(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// Targets of the links that lead into the repository.
fn targets(text: &str) -> Vec<String> {
    let prose = prose(text);
    let all = prose.split("](").skip(1).map(|rest| rest.split(')').next().expect("a link ends").to_owned());
    all.filter(|target| !target.contains("://")).collect()
}

/// The anchors of a text: its headings in lower case, without punctuation and with hyphens for spaces.
fn anchors(text: &str) -> Vec<String> {
    let prose = prose(text);
    let headings = prose.lines().filter(|line| line.starts_with('#'));
    let anchor = |heading: &str| -> String {
        let kept = heading.trim_start_matches('#').trim().to_lowercase();
        kept.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c)).map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    headings.map(anchor).collect()
}

#[test]
fn every_relative_link_leads_to_a_file_and_an_anchor() {
    let mut anchored = 0;
    for (path, text) in texts() {
        for target in targets(&text) {
            let (file, anchor) = target.split_once('#').map_or((target.as_str(), None), |(file, anchor)| (file, Some(anchor)));
            let meant = if file.is_empty() { path.clone() } else { path.with_file_name(file) };
            assert!(meant.exists(), "{} links to {target}", path.display());
            if let Some(anchor) = anchor {
                let there = anchors(&std::fs::read_to_string(&meant).expect("text"));
                assert!(there.iter().any(|known| known == anchor), "{} links to {target}", path.display());
                anchored += 1;
            }
        }
    }
    assert!(anchored > 0, "the files in docs refer to one another");
}

#[test]
fn the_readme_links_to_every_file_in_docs() {
    let texts = texts();
    let linked = targets(&texts[0].1);
    assert!(texts.len() > 1);
    for (path, _) in &texts[1..] {
        let name = path.file_name().expect("a name").to_string_lossy();
        assert!(linked.contains(&format!("docs/{name}")), "the README does not link to {name}");
    }
}

/// A path in backticks that begins with a folder of the repository, such as `src/router.rs`.
#[test]
fn every_path_that_is_named_exists() {
    let is_of_repository = |path: &str| {
        let folder = path.split_once('/').map_or("", |(folder, _)| folder);
        !folder.is_empty() && root().join(folder).is_dir() && !path.contains(['<', ' '])
    };
    let mut named = 0;
    for (file, text) in texts() {
        for path in quoted(&prose(&text)).filter(|path| is_of_repository(path)) {
            assert!(root().join(path).exists(), "{} names {path}", file.display());
            named += 1;
        }
    }
    assert!(named > 10, "{named} paths");
}
