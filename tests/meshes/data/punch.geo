// A cylinder for read_mesh_file: radius 1, from its contact face at z = 0 to
// its fixed one at z = 2, in tetrahedra; its one side is named, not flat.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 2, 1};
MeshSize {PointsOf{Volume{1};}} = 0.4;
Physical Surface("contact") = {3};
Physical Surface("fixed") = {2};
Physical Surface("sides") = {1};
Physical Volume("punch") = {1};
