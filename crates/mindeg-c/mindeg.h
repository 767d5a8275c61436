/* mindeg: meshes of polygons with few edges at every vertex, and proofs of how few are possible.
 *
 * This file is made by cbindgen from src/exported.rs; tests/c/run says so if it is not. Link with -lmindeg_c.
 *
 * All functions may be called from several threads at once, and threads may share one handle as long as none frees it.
 * A misuse that is not listed as an error (a freed handle, an array that is too short) is undefined, as ever in C.
 */

#ifndef MINDEG_H
#define MINDEG_H

#include <stddef.h>
#include <stdint.h>

/* A mesh, or the error that says why there is none. */
typedef struct MindegMesh MindegMesh;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 Meshes the polygon inside the first ring of points and outside the others.

 points: x and y of each point, ring after ring, without a gap. The boundary points of the mesh are these, bit for bit.
 ring_sizes: the number of points of each ring; rings do not repeat their first point, and run either way round.
 options: NULL, or JSON text: {"max_degree": 5}, {"keep_angle": "95%"}, {"interior": {"size_inside": 0.5}} and so on.

 The result is never NULL: ask mindeg_error, and give it to mindeg_free in the end.

 # Safety

 ring_sizes has ring_count entries, points twice their sum, and options ends with a zero byte or is NULL.
 */
MindegMesh *mindeg_mesh_rings(const double *points,
                              const size_t *ring_sizes,
                              size_t ring_count,
                              const char *options);

/*
 Meshes a domain given as JSON text, with spacing laws, curves, lines inside and degree limits.

 Points are added inside if the domain has the key "interior" and the options ask for no goal.
 The result is never NULL: ask mindeg_error, and give it to mindeg_free in the end.

 # Safety

 Both texts end with a zero byte; options may be NULL.
 */
MindegMesh *mindeg_mesh_domain(const char *domain, const char *options);

/*
 Why there is no mesh, as one line of UTF-8 text that lives as long as the handle; NULL if there is a mesh.
 */
const char *mindeg_error(const MindegMesh *mesh);

/*
 The number of points; 0 without a mesh.
 */
size_t mindeg_point_count(const MindegMesh *mesh);

/*
 x and y of each point, boundary points first. The array lives as long as the handle; NULL without a mesh.
 */
const double *mindeg_points(const MindegMesh *mesh);

/*
 The number of triangles; 0 without a mesh.
 */
size_t mindeg_triangle_count(const MindegMesh *mesh);

/*
 Three indices of points for each triangle, from 0, counter-clockwise. The array lives as long as the handle; NULL
 without a mesh.
 */
const uint32_t *mindeg_triangles(const MindegMesh *mesh);

/*
 The most edges at a vertex, boundary edges and edges outside the domain included; 0 without a mesh.
 */
uint32_t mindeg_max_degree(const MindegMesh *mesh);

/*
 The minimum angle of all triangles, in degrees; NaN without a mesh.
 */
double mindeg_min_angle(const MindegMesh *mesh);

/*
 The facts that are known and proven of the mesh: JSON text with keys of `mindeg mesh --json`. It lives as long as the handle; NULL
 without a mesh.
 */
const char *mindeg_report(const MindegMesh *mesh);

/*
 Frees a handle and all that lives as long as it. NULL does nothing.
 */
void mindeg_free(MindegMesh *mesh);

/*
 The version of the library, such as "0.1.0".
 */
const char *mindeg_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* MINDEG_H */
