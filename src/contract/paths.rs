//! The paths of the service, as its contract has them: what may be done at each, and which one was probably meant.

use utoipa::openapi::OpenApi as Document;

use crate::words::nearest;

/// A path with its methods.
pub(super) struct Known {
    template: String,
    methods: Vec<&'static str>,
}

/// The paths of a document, and those of the pages, which it does not describe.
pub(super) fn known(document: &Document) -> Vec<Known> {
    let of_contract = document.paths.paths.iter().map(|(template, item)| {
        let methods = [(item.get.is_some(), "GET"), (item.post.is_some(), "POST")];
        let methods = methods.into_iter().filter(|(is_there, _)| *is_there).map(|(_, name)| name).collect();
        Known { template: template.clone(), methods }
    });
    let pages = ["/", "/docs"].map(|page| Known { template: page.to_owned(), methods: vec!["GET"] });
    of_contract.chain(pages).collect()
}

/// The methods of a path, in words; none of a path that is not in the contract.
pub(super) fn methods_of(known: &[Known], path: &str) -> Option<String> {
    let known = known.iter().find(|known| matches(&known.template, path))?;
    Some(known.methods.join(" or "))
}

/// The path that was probably meant by one that is not there.
pub(super) fn meant_by<'a>(known: &'a [Known], path: &str) -> Option<&'a str> {
    const LONGEST: usize = 100;
    if path.len() > LONGEST {
        return None;
    }
    let fixed: Vec<&str> = known.iter().map(|known| known.template.as_str()).filter(|template| !template.contains('{')).collect();
    let path = path.trim_end_matches('/');
    let versioned = format!("/v1{path}");
    let exact = fixed.iter().copied().find(|known| *known == path || *known == versioned);
    let of_version: Vec<&str> = fixed.iter().filter_map(|known| known.strip_prefix("/v1/")).collect();
    let last = path.strip_prefix("/v1").unwrap_or(path).trim_start_matches('/');
    let near = || {
        nearest(last, &of_version).and_then(|near| fixed.iter().copied().find(|known| known.strip_prefix("/v1/") == Some(near)))
    };
    exact.filter(|known| *known != "/").or_else(near)
}

fn matches(template: &str, path: &str) -> bool {
    let (mut template, mut path) = (template.split('/'), path.split('/'));
    loop {
        match (template.next(), path.next()) {
            (None, None) => return true,
            (Some(known), Some(part)) if known == part || known.starts_with('{') => {}
            _ => return false,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::router::contract;

    #[test]
    fn the_nearest_path_is_the_one_meant() {
        for (path, meant) in [
            ("/v1/force", "/v1/forces"),
            ("/forces", "/v1/forces"),
            ("/v1/soils/", "/v1/soils"),
            ("/v1/slip_sweep", "/v1/slip-sweep"),
            ("/wheel", "/v1/wheels"),
        ] {
            assert_eq!(contract().meant_by(path), Some(meant), "{path}");
        }
        for path in ["/", "/nope", "/v1", "/v1/", "/favicon.png"] {
            assert_eq!(contract().meant_by(path), None, "{path}");
        }
    }

    #[test]
    fn methods_are_those_of_the_contract() {
        assert_eq!(contract().methods_of("/v1/forces").as_deref(), Some("GET or POST"));
        assert_eq!(contract().methods_of("/v1/coupled").as_deref(), Some("POST"));
        assert_eq!(contract().methods_of("/v1/wheels/letter").as_deref(), Some("GET"));
        assert_eq!(contract().methods_of("/static/main.js"), None);
    }
}
