// Which way a surface looks at its corners.

/**
 * The sum of the triangles' normals around each corner, each as long as twice its triangle's area.
 * @param places x, y, z of each corner
 * @param triangles three corners each
 * @param out of the same length as places; not of unit length
 */
export function addNormals(places, triangles, out) {
  out.fill(0);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ux, uy, uz] = [places[b] - places[a], places[b + 1] - places[a + 1], places[b + 2] - places[a + 2]];
    const [vx, vy, vz] = [places[c] - places[a], places[c + 1] - places[a + 1], places[c + 2] - places[a + 2]];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (let k = 0; k < 3; k += 1) {
      const at = 3 * triangles[t + k];
      out[at] += x;
      out[at + 1] += y;
      out[at + 2] += z;
    }
  }
}
