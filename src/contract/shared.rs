//! Makes one component of what several operations say alike: their failures and their parameters.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use terramechanics_reading::component_name;
use utoipa::openapi::path::{Operation, Parameter};
use utoipa::openapi::response::Response;
use utoipa::openapi::{OpenApi, Ref, RefOr};

/// The operations of a document.
pub(super) fn operations(document: &mut OpenApi) -> impl Iterator<Item = &mut Operation> {
    document.paths.paths.values_mut().flat_map(|item| [&mut item.get, &mut item.post].into_iter().flatten())
}

/// Puts a reference in place of each failure and each parameter that stands more than once.
pub(super) fn share(document: &mut OpenApi) {
    let mut failures = Alike::default();
    let mut parameters = Alike::default();
    for operation in operations(document) {
        operation.responses.responses.values().for_each(|response| failures.count(response, failure_name));
        operation.parameters.iter().flatten().for_each(|parameter| parameters.count(parameter, parameter_name));
    }
    for operation in operations(document) {
        operation.responses.responses.values_mut().for_each(|response| failures.refer(response, failure_name, "responses"));
        operation.parameters.iter_mut().flatten().for_each(|parameter| parameters.refer(parameter, parameter_name, "parameters"));
    }
    let components = document.components.get_or_insert_default();
    components.responses.extend(failures.into_components());
    components.parameters.extend(parameters.into_components());
}

/// The name of a failure: that of its problem.
fn failure_name(response: &Response) -> Option<String> {
    let content = response.content.get("application/problem+json")?;
    let RefOr::T(content) = content else { return None };
    let kind = content.example.as_ref()?.get("type")?.as_str()?;
    Some(component_name(kind.rsplit('/').next()?.split('-')))
}

/// The name of a parameter.
fn parameter_name(parameter: &Parameter) -> Option<String> {
    Some(parameter.name.clone())
}

/// Things by name, each with the number of places where it stands; of one name there may be several.
struct Alike<T>(BTreeMap<String, Vec<(T, usize)>>);

impl<T> Default for Alike<T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<T: Clone + PartialEq> Alike<T> {
    fn count(&mut self, thing: &RefOr<T>, name: impl Fn(&T) -> Option<String>) {
        let RefOr::T(thing) = thing else { return };
        let Some(name) = name(thing) else { return };
        let known = self.0.entry(name).or_default();
        match known.iter_mut().find(|(known, _)| known == thing) {
            Some((_, places)) => *places += 1,
            None => known.push((thing.clone(), 1)),
        }
    }

    /// The things of a name that stand in several places, those in most places first, each with the name of its component.
    fn shared(&self, name: &str) -> impl Iterator<Item = (String, &T)> {
        let mut several: Vec<_> = self.0.get(name).into_iter().flatten().filter(|(_, places)| *places > 1).collect();
        several.sort_by_key(|(_, places)| Reverse(*places));
        let component = move |i: usize| if i == 0 { name.to_owned() } else { format!("{name}-{}", i + 1) };
        several.into_iter().enumerate().map(move |(i, (thing, _))| (component(i), thing))
    }

    fn refer(&self, thing: &mut RefOr<T>, name: impl Fn(&T) -> Option<String>, kind: &str) {
        let RefOr::T(own) = thing else { return };
        if let Some(name) = name(own)
            && let Some((component, _)) = self.shared(&name).find(|(_, shared)| *shared == own)
        {
            *thing = RefOr::Ref(Ref::new(format!("#/components/{kind}/{component}")));
        }
    }

    fn into_components(self) -> Vec<(String, RefOr<T>)> {
        let named = |(component, thing): (String, &T)| (component, RefOr::T(thing.clone()));
        self.0.keys().flat_map(|name| self.shared(name)).map(named).collect()
    }
}
