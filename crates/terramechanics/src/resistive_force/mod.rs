mod stiffness;
