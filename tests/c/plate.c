/* Meshes a square with a hole, first of its boundary points alone, then with points inside, and prints both. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "mindeg.h"

static const double points[] = {0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2};
static const size_t ring_sizes[] = {4, 4};
static const char *plate = "{\"rectangle\": {\"width\": 4, \"height\": 3}, \"size\": 0.5}";

static int print(const char *name, MindegMesh *mesh) {
    const char *error = mindeg_error(mesh);
    if (error != NULL) {
        printf("%s: %s\n", name, error);
        mindeg_free(mesh);
        return 1;
    }
    size_t count = mindeg_triangle_count(mesh);
    const uint32_t *triangles = mindeg_triangles(mesh);
    const double *at = mindeg_points(mesh);
    double area = 0;
    for (size_t i = 0; i < 3 * count; i += 3) {
        const double *a = at + 2 * triangles[i], *b = at + 2 * triangles[i + 1], *c = at + 2 * triangles[i + 2];
        area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    printf("%s: %zu points, %zu triangles, maximum degree %u, minimum angle %.3f, area %.6f\n", name,
           mindeg_point_count(mesh), count, (unsigned)mindeg_max_degree(mesh), mindeg_min_angle(mesh), area);
    printf("%s: %.60s\n", name, mindeg_report(mesh));
    if (strcmp(name, "least") == 0) {
        /* The outline comes first and as it was; a hole runs clockwise in the mesh. */
        printf("the outline is %s\n", memcmp(at, points, 8 * sizeof *points) == 0 ? "bit for bit as it was" : "another");
    }
    mindeg_free(mesh);
    return 0;
}

static void *work(void *same) {
    MindegMesh *mesh = mindeg_mesh_domain(plate, "{\"interior\": {\"growth\": 0.2}}");
    *(size_t *)same = mindeg_triangle_count(mesh);
    mindeg_free(mesh);
    return NULL;
}

int main(void) {
    printf("version %s\n", mindeg_version());
    print("least", mindeg_mesh_rings(points, ring_sizes, 2, NULL));
    print("inside", mindeg_mesh_domain(plate, "{\"interior\": {}}"));
    print("domain", mindeg_mesh_domain("{\"rectangle\": {\"width\": 4, \"height\": 3}, \"size\": 1}", "{\"max_degree\": 5}"));

    /* Mistakes are errors, and nothing of them has points. */
    print("option", mindeg_mesh_rings(points, ring_sizes, 2, "{\"degree\": 5}"));
    print("limit", mindeg_mesh_rings(points, ring_sizes, 2, "{\"max_degree\": 3}"));
    print("bytes", mindeg_mesh_domain("\xff", NULL));
    print("null", mindeg_mesh_domain(NULL, NULL));
    print("no points", mindeg_mesh_rings(NULL, ring_sizes, 2, NULL));
    print("no rings", mindeg_mesh_rings(NULL, NULL, 0, NULL));
    const size_t huge[] = {(size_t)-1, 2};
    print("huge", mindeg_mesh_rings(points, huge, 2, NULL));
    printf("of nothing: %s, %zu, %zu, %u, %d, %d\n", mindeg_error(NULL), mindeg_point_count(NULL),
           mindeg_triangle_count(NULL), (unsigned)mindeg_max_degree(NULL), isnan(mindeg_min_angle(NULL)) != 0,
           mindeg_points(NULL) == NULL && mindeg_triangles(NULL) == NULL && mindeg_report(NULL) == NULL);
    mindeg_free(NULL);

    pthread_t threads[4];
    size_t counts[4];
    for (int i = 0; i < 4; i++) pthread_create(&threads[i], NULL, work, &counts[i]);
    for (int i = 0; i < 4; i++) pthread_join(threads[i], NULL);
    printf("threads: %s\n", counts[0] > 26 && counts[0] == counts[1] && counts[0] == counts[2] && counts[0] == counts[3]
                                ? "the same mesh" : "different meshes");
    return 0;
}
