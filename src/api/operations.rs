//! The operations put together, each with its example.

use terramechanics_reading::Node;
use utoipa::openapi::path::{Operation, PathItem};
use utoipa::openapi::schema::ArrayBuilder;
use utoipa::openapi::{Content, Ref, RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};
use utoipa_axum::router::{OpenApiRouter, UtoipaMethodRouter};

use super::room::Room;
use crate::compute::Pace;
use crate::contract::{Example, Shown};
use crate::reply::AssumedReply;
use crate::request::assume::ASSUME;
use crate::request::checked;
use crate::state::Service;

/// Operations, in the order of the contract.
pub(crate) struct Operations {
    pub(crate) router: OpenApiRouter<Service>,
    pub(crate) shown: Vec<Shown>,
}

impl Operations {
    pub(crate) fn new() -> Self {
        Self { router: OpenApiRouter::new(), shown: Vec::new() }
    }

    /// With the operations of a room: its POST, and its GET where it has one.
    pub(crate) fn room<R: Room>(self, mut routes: UtoipaMethodRouter<Service>) -> Self {
        if R::OBJECT.names().contains(&ASSUME.name) {
            let answers = routes.1.paths.values().filter_map(answer_of).collect::<Vec<_>>();
            routes.0.iter_mut().filter(|(name, _)| answers.contains(name)).for_each(|(_, schema)| with_assumed(schema));
            routes.0.push((AssumedReply::name().into_owned(), AssumedReply::schema()));
        }
        self.shown(routes, example_of::<R>)
    }

    /// With an operation that has an example.
    pub(crate) fn shown(mut self, routes: UtoipaMethodRouter<Service>, example: fn() -> Example) -> Self {
        let paths = routes.1.paths.keys().cloned();
        self.shown.extend(paths.map(|path| Shown { path, example }));
        self.plain(routes)
    }

    /// With an operation that needs no example.
    pub(crate) fn plain(mut self, mut routes: UtoipaMethodRouter<Service>) -> Self {
        routes.1.paths.values_mut().for_each(describe_twin);
        self.router = self.router.routes(routes);
        self
    }
}

/// What the contract shows of a room.
fn example_of<R: Room>() -> Example {
    let request = R::example();
    let case = checked::<R>(&Node::from(&request)).ok();
    let reply = case.and_then(|case: R| case.reply(&Pace::at_once()).ok());
    Example { replies: reply.map_or_else(Vec::new, |reply| Example::replies_of(&reply)), request: Some(request) }
}

/// The name of the answer of a POST in JSON.
fn answer_of(item: &PathItem) -> Option<String> {
    let RefOr::T(response) = item.post.as_ref()?.responses.responses.get("200")? else { return None };
    match response.content.get("application/json")? {
        RefOr::T(Content { schema: Some(RefOr::Ref(answer)), .. }) => answer.ref_location.rsplit('/').next().map(str::to_owned),
        _ => None,
    }
}

/// Adds to the schema of an answer what was assumed for it, which stands there wherever a request allows it.
fn with_assumed(schema: &mut RefOr<Schema>) {
    const MEANING: &str = "What was assumed; absent where the request did not allow it.";
    if let RefOr::T(Schema::Object(object)) = schema {
        let list = ArrayBuilder::new().items(Ref::from_schema_name(AssumedReply::name())).description(Some(MEANING));
        object.properties.insert("assumed".to_owned(), list.into());
    }
}

/// How a query says what a body says.
const OF_QUERY: &str = "The twin of the POST: a field is a parameter, one inside an object has the object's name and a dot before its own\n\
                        (`soil.cohesion_pa=200`). The answer, the checks and the problems are those of the POST; their pointers\n\
                        (`/soil/cohesion_pa`) have a slash for the dot.";

/// Says of a GET beside a POST that it does the same: its answer is described once.
fn describe_twin(item: &mut PathItem) {
    let (Some(Operation { summary, responses, .. }), Some(twin)) = (&item.post, &mut item.get) else { return };
    twin.summary = summary.as_ref().map(|summary| format!("{summary}, asked by a query"));
    twin.description = Some(OF_QUERY.to_owned());
    twin.responses.responses.extend(responses.responses.get("200").map(|answer| ("200".to_owned(), answer.clone())));
}
