// From a mesh file to spheres for another program: read an OBJ, build its sphere tree, say how well
// each level fits, and write one level as URDF and the whole tree as .sph.
#include <cstdio>

#include <lodlab/io/files/output_file.hpp>
#include <lodlab/io/sphere_files.hpp>
#include <lodlab/lod3d/builder/build_tree.hpp>
#include <lodlab/lod3d/builder/tree_report.hpp>
#include <lodlab/lod3d/source/load_mesh.hpp>

int main() {
    // A file of yours; here a wedge: two triangles and three quadrangles.
    lod::write_text_file("wedge.obj",
                         "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 0 1 1\n"
                         "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n");

    const lod3d::Solid wedge = lod3d::make_solid("wedge", lod3d::load_mesh("wedge.obj"));
    std::printf("%s: %zu triangles, %.3f m^3\n", wedge.name.c_str(), wedge.mesh.triangles.size(),
                wedge.volume);

    const lod::SphereTree<3> tree = lod3d::build_tree(wedge, {.depth = 2, .effort = 0.1});
    bool covered = true;
    for (const lod::LevelReport& level : lod3d::report_tree(wedge, tree).levels) {
        std::printf("level %d: %3d spheres, they stand out by %.3f m at most\n", level.level,
                    level.nodes, level.worst_protrusion);
        covered = covered && level.certified;
    }

    const io::SphereExport spheres{tree, wedge.centroid, 1, wedge.name};
    for (const char* path : {"wedge.urdf", "wedge.sph"})
        lod::write_text_file(path, io::sphere_format_of(path)->text(spheres));
    return covered ? 0 : 1;
}
