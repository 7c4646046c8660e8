//! The page and the explorer: served whole, with a policy, from the binary alone.

use axum::body::Body;

use terramechanics_server::{Limits, Outside, Service};

use crate::asking::{get, request, send, send_to, send_unpacking};

#[test]
fn the_page_has_a_strict_policy() {
    let page = get("/");
    assert_eq!(page.status, 200);
    assert!(page.header("content-type").starts_with("text/html"));
    let policy = page.header("content-security-policy");
    assert!(
        policy.contains("default-src 'none'") && policy.contains("script-src 'self'") && !policy.contains("unsafe"),
        "{policy}"
    );
    assert_eq!(page.header("x-content-type-options"), "nosniff");
}

#[test]
fn every_file_the_page_names_is_served() {
    let read = every_file_from("/");
    assert!(
        read.iter().filter(|path| path.ends_with(".js")).count() >= 5 && read.iter().any(|path| path.ends_with(".css")),
        "{read:?}"
    );
}

/// The files that a page and its modules name: each is there, of the right type, and nothing comes from elsewhere.
fn every_file_from(page: &str) -> Vec<String> {
    let mut to_read = vec![page.to_owned()];
    let mut read: Vec<String> = Vec::new();
    while let Some(path) = to_read.pop() {
        if read.contains(&path) {
            continue;
        }
        let file = get(&path);
        assert_eq!(file.status, 200, "{path}");
        assert!(!file.text.contains("://cdn") && !file.text.contains("src=\"http"), "{path} comes from elsewhere");
        let content_type = file.header("content-type");
        for (ending, expected) in [(".js", "text/javascript"), (".css", "text/css"), (".svg", "image/svg+xml")] {
            assert!(!path.ends_with(ending) || content_type.starts_with(expected), "{path} is {content_type}");
        }
        // Behind a proxy the root may be elsewhere.
        for absolute in ["href=\"/", "src=\"/", "fetch(\"/", "fetch(`/", "href: `/", "href: \"/"] {
            assert!(!file.text.contains(absolute), "{path} has {absolute}");
        }
        assert!(!file.header("content-security-policy").is_empty(), "{path} has no policy");
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        for quoted in file.text.split(['"', '\'']) {
            if quoted.starts_with("./") || quoted.starts_with("../") {
                to_read.push(resolved(folder, quoted));
            } else if quoted.starts_with("static/") && quoted.contains('.') {
                // Both pages stand at the root, or at the root of what a proxy serves.
                to_read.push(format!("/{quoted}"));
            }
        }
        read.push(path);
    }
    read
}

/// The path of a module that another one in `folder` imports.
fn resolved(folder: &str, import: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').collect();
    for part in import.split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            name => parts.push(name),
        }
    }
    parts.join("/")
}

#[test]
fn a_file_that_has_not_changed_is_not_sent_again() {
    let tag = get("/").header("etag").to_owned();
    assert!(!tag.is_empty());
    let again = send(request("GET", "/", &[("if-none-match", &tag)], Body::empty()));
    assert_eq!((again.status.as_u16(), again.text.as_str()), (304, ""));
    assert_eq!(send(request("GET", "/", &[("if-none-match", "\"other\"")], Body::empty())).status, 200);
}

#[test]
fn what_stays_the_same_is_packed_for_those_who_take_it() {
    for path in ["/static/styles/base.css", "/docs", "/openapi.json"] {
        let plain = get(path);
        let (packed, sent) = send_unpacking(request("GET", path, &[("accept-encoding", "br;q=0, gzip")], Body::empty()));
        assert_eq!((packed.status.as_u16(), packed.header("content-encoding")), (200, "gzip"), "{path}");
        assert_eq!((plain.header("content-encoding"), plain.header("vary")), ("", "accept-encoding"));
        assert!(packed.text == plain.text && sent < 3 * plain.text.len() / 4, "{path}: {sent} of {}", plain.text.len());
        // Two forms of one text are told apart by their tags, and each is known again by its own.
        let tags = [plain.header("etag"), packed.header("etag")];
        assert!(tags[0] != tags[1] && tags.iter().all(|tag| tag.starts_with('"') && tag.len() > 10), "{tags:?}");
        for (tag, coding) in tags.into_iter().zip(["identity", "gzip"]) {
            let headers = [("if-none-match", tag), ("accept-encoding", coding)];
            let again = send(request("GET", path, &headers, Body::empty()));
            assert_eq!((again.status.as_u16(), again.text.as_str()), (304, ""), "{path} {coding}");
            assert_eq!(again.header("etag"), tag);
        }
    }
}

#[test]
fn the_explorer_is_a_page_like_the_other() {
    let page = get("/docs");
    assert_eq!(page.status, 200);
    assert_eq!(page.header("content-security-policy"), get("/").header("content-security-policy"));
    assert!(every_file_from("/docs").iter().any(|path| path.ends_with(".js")));
    assert_eq!(get("/docs/").header("location"), "../docs");
}

#[test]
fn the_contract_names_the_public_address() {
    let servers =
        |service| send_to(service, request("GET", "/openapi.json", &[], Body::empty())).ok()["servers"][0]["url"].clone();
    let public_url = "https://example.org/soil";
    let outside = Outside { public_url: Some(public_url.into()), ..Outside::default() };
    assert_eq!(servers(Service::seen_as(Limits::default(), outside)), public_url);
    assert_eq!(servers(Service::new(Limits::default())), "/");
}
