//! The contract: an OpenAPI document of the operations, generated from their code.

mod examples;
mod part;
mod paths;
mod shared;

use std::fmt;
use std::sync::{Arc, OnceLock};

use axum::Extension;
use axum::body::Bytes;
use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::Response;
use utoipa::OpenApi;
use utoipa::openapi::OpenApi as Document;
use utoipa::openapi::tag::TagBuilder;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

pub(crate) use self::examples::{Example, Shown, replies_of_texts};
use self::part::ContractCase;
use self::paths::Known;
use crate::answer::json_text;
use crate::api::responses::{InvalidQuery, Limits};
use crate::compute::{Cost, Pace};
use crate::extract::AskedOnly;
use crate::fixed::Fixed;
use crate::problem::Problem;
use crate::quantity;
use crate::request::Documented;
use crate::state::Service;

#[derive(OpenApi)]
#[openapi(
    info(
        title = "Terramechanics",
        description = "Steady forces of a rigid wheel, with or without lugs, rolling on deformable soil: drawbar pull, normal force, torque, \
                       sinkage and stresses. SI units and radians; the suffix of a field is its unit. Slip is −1 (locked) … 0 (rolling) … 1 \
                       (spinning). Angles are measured at the wheel's centre from straight down, positive towards the front. A null for a field of a request that may be left \
                       out is as if it were left out. Every failure is an RFC 9457 problem document. Every answer of /v1 names the version of the model in the header X-Model-Version and that of the catalogue in X-Catalogue-Version.",
        contact(name = "The terramechanics project"),
        license(name = "MIT", identifier = "MIT")
    ),
    components(schemas(crate::problem::ProblemBody)),
    servers((url = "/", description = "This server")),
    security(())
)]
struct Frame;

/// The document before it has operations.
pub(crate) fn frame() -> Document {
    let tag = |(name, about)| TagBuilder::new().name(name).description(Some(about)).build();
    let mut frame = Frame::openapi();
    frame.tags = Some(part::TAGS.map(tag).into());
    frame
}

/// Makes the document without examples, which take a while to compute, and what the examples are of.
pub(crate) type Source = fn() -> (Document, Vec<Shown>);

/// The contract of the service that is running.
#[derive(Default)]
pub struct Contract {
    /// The document is made when it is asked for: it takes megabytes, and most services are never asked.
    source: OnceLock<Source>,
    known: OnceLock<Vec<Known>>,
    /// Where the service is for those outside, if that was set.
    public_url: OnceLock<String>,
    text: OnceLock<Bytes>,
    fixed: OnceLock<Fixed>,
}

impl fmt::Debug for Contract {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contract").field("is_written", &self.text.get().is_some()).finish_non_exhaustive()
    }
}

impl Contract {
    /// Says what the contract describes, and how that is made anew; the first word stands.
    pub(crate) fn describe(&self, document: &Document, source: Source) {
        self.known.get_or_init(|| paths::known(document));
        self.source.get_or_init(|| source);
    }

    /// Says where the service is for those outside; the first word stands.
    pub(crate) fn served_at(&self, public_url: &str) {
        self.public_url.get_or_init(|| public_url.to_owned());
    }

    /// The document, with its examples.
    #[must_use]
    pub fn document(&self) -> Document {
        let (mut document, shown) = self.source.get().map_or_else(|| (frame(), Vec::new()), |source| source());
        if let (Some(url), Some(server)) = (self.public_url.get(), document.servers.iter_mut().flatten().next()) {
            server.url.clone_from(url);
        }
        if let Some(components) = &mut document.components {
            quantity::add_units(&mut components.schemas);
        }
        examples::attach(&mut document, &shown);
        shared::share(&mut document);
        document
    }

    /// The document as text, as it is served. The first call computes all examples.
    pub fn text(&self) -> &Bytes {
        self.text.get_or_init(|| self.document().to_json().unwrap_or_default().into())
    }

    /// The document as text for those who read it, as it is committed.
    #[must_use]
    pub fn pretty_text(&self) -> String {
        self.document().to_pretty_json().unwrap_or_default() + "\n"
    }

    /// The text as it is sent.
    fn fixed(&self) -> &Fixed {
        self.fixed.get_or_init(|| Fixed::tagged(self.text().clone(), "application/json"))
    }

    /// The operations of these tags alone.
    fn part(&self, tags: &[&str]) -> Bytes {
        let mut document = serde_json::from_slice(self.text()).unwrap_or_default();
        part::keep(&mut document, tags);
        document.to_string().into()
    }

    /// The methods of a path, in words; none of a path that is not in the contract.
    pub(crate) fn methods_of(&self, path: &str) -> Option<String> {
        paths::methods_of(self.known(), path)
    }

    /// The path that was probably meant by one that is not there.
    pub(crate) fn meant_by(&self, path: &str) -> Option<&str> {
        paths::meant_by(self.known(), path)
    }

    fn known(&self) -> &[Known] {
        self.known.get().map_or(&[], Vec::as_slice)
    }
}

/// The operation that answers with the contract.
pub(crate) fn route(contract: &Arc<Contract>) -> OpenApiRouter<Service> {
    OpenApiRouter::new().routes(routes!(openapi)).layer(Extension(contract.clone()))
}

/// The contract
///
/// This document, or a part of it.
#[utoipa::path(
    get,
    path = "/openapi.json",
    tag = "operations",
    params(ContractQuery),
    responses((status = 200, description = "The OpenAPI document", body = serde_json::Value), InvalidQuery, Limits)
)]
async fn openapi(
    State(service): State<Service>,
    Extension(contract): Extension<Arc<Contract>>,
    headers: HeaderMap,
    AskedOnly(ContractCase(tags)): AskedOnly<ContractCase>,
) -> Result<Response, Problem> {
    if let (None, Some(fixed)) = (&tags, contract.fixed.get()) {
        return Ok(fixed.answer(&headers));
    }
    let answer =
        move |_: &Pace| Ok(tags.map_or_else(|| contract.fixed().answer(&headers), |tags| json_text(contract.part(&tags))));
    service.pool().run(Cost::of_contract(), answer).await
}

type ContractQuery = Documented<ContractCase>;
