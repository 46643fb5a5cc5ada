// A coated block for read_mesh_file: 4 x 2 mm, the coating's face up at z = 3,
// meshed in hexahedra by extruding it downwards. Lengths are in millimetres.
Point(1) = {1, 5, 3};
Point(2) = {5, 5, 3};
Point(3) = {5, 7, 3};
Point(4) = {1, 7, 3};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 5;
Transfinite Curve {2, 4} = 3;
Transfinite Surface {1};
Recombine Surface {1};

coating[] = Extrude {0, 0, -0.5} { Surface{1}; Layers{2}; Recombine; };
bulk[] = Extrude {0, 0, -1.5} { Surface{coating[0]}; Layers{3}; Recombine; };

Physical Surface("contact") = {1};
Physical Surface("fixed") = {bulk[0]};
Physical Volume("coating", 10) = {coating[1]};
Physical Volume("bulk", 20) = {bulk[1]};
