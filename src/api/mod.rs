//! The operations of the API: each takes a checked request and returns an answer or a problem.

mod catalogue;
mod compare;
mod coupled;
mod forces;
mod identify;
mod model;
mod operations;
mod resistances;
mod responses;
mod slip_sweep;
mod stress_profile;
mod towed;
mod track;
mod validation;

use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::app::Service;

/// All routes that the contract documents.
pub(crate) fn routes() -> OpenApiRouter<Service> {
    OpenApiRouter::new()
        .routes(routes!(forces::forces, forces::forces_of_query))
        .routes(routes!(stress_profile::stress_profile, stress_profile::stress_profile_of_query))
        .routes(routes!(slip_sweep::slip_sweep, slip_sweep::slip_sweep_of_query))
        .routes(routes!(compare::compare))
        .routes(routes!(coupled::coupled))
        .routes(routes!(resistances::resistances, resistances::resistances_of_query))
        .routes(routes!(towed::towed))
        .routes(routes!(identify::identify))
        .routes(routes!(identify::plates))
        .routes(routes!(identify::shear))
        .routes(routes!(track::track))
        .routes(routes!(catalogue::wheels))
        .routes(routes!(catalogue::wheel))
        .routes(routes!(catalogue::soils))
        .routes(routes!(catalogue::soil))
        .routes(routes!(validation::validation))
        .routes(routes!(validation::validation_set))
        .routes(routes!(model::model))
        .routes(routes!(operations::healthz))
        .routes(routes!(operations::readyz))
        .routes(routes!(operations::metrics))
        .routes(routes!(operations::openapi))
}
