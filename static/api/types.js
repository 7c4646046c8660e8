// The types of the API. The checks generate them from its contract, openapi/openapi.json.

/** @typedef {import("contract").components["schemas"]} Schemas */

/** @typedef {Schemas["Forces"]} Forces */
/** @typedef {Schemas["ForcesRequest"]} ForcesRequest */
/** @typedef {Schemas["StressProfile"]} StressProfile */
/** @typedef {Schemas["StressProfileRequest"]} StressProfileRequest */
/** @typedef {Schemas["SlipSweep"]} SlipSweep */
/** @typedef {Schemas["SlipSweepRequest"]} SlipSweepRequest */
/** @typedef {Schemas["SweepColumns"]} SweepColumns */
/** @typedef {Schemas["Comparison"]} Comparison */
/** @typedef {Schemas["CompareRequest"]} CompareRequest */
/** @typedef {Schemas["Difference"]} Difference */
/** @typedef {Schemas["Spread"]} Spread */
/** @typedef {Schemas["Angles"]} Angles */
/** @typedef {Schemas["ProfileColumns"]} ProfileColumns */
/** @typedef {Schemas["Warning"]} Warning */
/** @typedef {Schemas["FieldFault"]} FieldFault */
/** @typedef {Partial<Schemas["Problem"]>} ProblemDocument */
/** @typedef {Schemas["Wheel"]} Wheel */
/** @typedef {Schemas["Soil"]} Soil */
/** @typedef {Schemas["Contact"]} Contact */
/** @typedef {NonNullable<ForcesRequest["method"]>} Method */
/** @typedef {Schemas["CatalogueWheel"]} CatalogueWheel */
/** @typedef {Schemas["CatalogueSoil"]} CatalogueSoil */
/** @typedef {Schemas["CatalogueValue"]} CatalogueValue */
/** @typedef {Schemas["CatalogueSubstitute"]} CatalogueSubstitute */
/** @typedef {Schemas["CatalogueLaw"]} CatalogueLaw */
/** @typedef {{ wheels: Map<string, CatalogueWheel>, soils: Map<string, CatalogueSoil> }} Catalogue */
/** @typedef {Schemas["Identification"]} Identification */
/** @typedef {Schemas["IdentifyRequest"]} IdentifyRequest */
/** @typedef {IdentifyRequest["fit"][number]} FitParameter */
/** @typedef {Schemas["ParameterEstimate"]} ParameterEstimate */
/** @typedef {Schemas["FitData"]} FitData */
/** @typedef {Schemas["Track"]} Track */
/** @typedef {Schemas["TrackRequest"]} TrackRequest */
/** @typedef {Schemas["TrackColumns"]} TrackColumns */
/** @typedef {Schemas["TrackEvent"]} TrackEvent */
/** @typedef {Schemas["VehicleRequest"]} VehicleRequest */
/** @typedef {Schemas["VehicleOnSlope"]} VehicleOnSlope */
/** @typedef {Schemas["VehicleOverSlopes"]} VehicleOverSlopes */
/** @typedef {Schemas["Model"]} Model */
/** @typedef {Schemas["Equation"]} Equation */
/** @typedef {Schemas["ParameterNote"]} ParameterNote */
/** @typedef {Schemas["LawNote"]} LawNote */
/** @typedef {Schemas["ValidationSet"]} ValidationSet */
/** @typedef {Schemas["ValidationResult"]} ValidationResult */

export {};
