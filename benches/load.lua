-- What wrk sends: one operating point by the explicit method, spelled out.
wrk.method = "POST"
wrk.headers["Content-Type"] = "application/json"
wrk.body = [[{"wheel":{"radius_m":0.2,"width_m":0.1,"lug_height_m":0.01,"lug_coefficient":0.5},"soil":{"cohesion_pa":170,"friction_angle_rad":0.478,"shear_modulus_m":0.005,"pressure_sinkage":{"law":"bekker","k_c":-660,"k_phi":754130,"n0":0.91,"n1":0.1}},"slip":0.2,"sinkage_m":0.02,"method":"explicit"}]]
