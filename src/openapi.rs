//! The contract: an OpenAPI document, generated from the routes.

use std::sync::OnceLock;

use axum::Router;
use utoipa::OpenApi;
use utoipa::openapi::OpenApi as Document;
use utoipa_axum::router::OpenApiRouter;

use crate::app::Service;
use crate::{api, examples, quantity};

#[derive(OpenApi)]
#[openapi(
    info(
        title = "Terramechanics",
        description = "Steady forces of a rigid wheel, with or without lugs, rolling on deformable soil: drawbar pull, normal force, torque, \
                       sinkage and stresses. SI units and radians; the suffix of a field is its unit. Slip is −1 (locked) … 0 (rolling) … 1 \
                       (spinning). Angles are measured at the wheel's centre from straight down, positive towards the front. Every failure is \
                       an RFC 9457 problem document. Every answer of /v1 names the version of the model in the header X-Model-Version.",
        contact(name = "The terramechanics project"),
        license(name = "MIT", identifier = "MIT")
    ),
    components(schemas(crate::problem::ProblemBody)),
    servers((url = "/", description = "This server")),
    security(()),
    tags(
        (name = "forces", description = "Forces and stresses of a wheel"),
        (name = "identification", description = "Parameters of soil and contact from measurements"),
        (name = "catalogue", description = "Wheels, soils, measurements and equations, with their sources"),
        (name = "operations", description = "For operators and tools")
    )
)]
struct Contract;

fn router() -> OpenApiRouter<Service> {
    OpenApiRouter::with_openapi(Contract::openapi()).merge(api::routes())
}

/// The routes that the document describes.
pub(crate) fn documented_routes() -> Router<Service> {
    router().split_for_parts().0
}

/// The document.
#[must_use]
pub fn document() -> Document {
    let mut document = router().into_openapi();
    if let Some(components) = &mut document.components {
        quantity::add_units(&mut components.schemas);
    }
    examples::attach(&mut document);
    document
}

static TEXT: OnceLock<String> = OnceLock::new();

/// Whether the text is there, so that serving it is no work.
pub(crate) fn is_written() -> bool {
    TEXT.get().is_some()
}

/// The document as text, as it is served and committed. The first call computes all examples.
pub fn text() -> &'static str {
    TEXT.get_or_init(|| {
        let mut text = document().to_pretty_json().unwrap_or_default();
        text.push('\n');
        text
    })
}
