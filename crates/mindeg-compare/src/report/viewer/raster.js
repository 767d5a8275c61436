// A mesh in space drawn without WebGL: a depth buffer on a canvas.

class Raster {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.scene = scene;
    this.context = canvas.getContext("2d");
  }

  color(steps) {
    this.steps = steps;
  }

  /** Draws, on every second pixel of the screen while it moves. */
  draw(camera, look, isMoving) {
    const { canvas, scene } = this;
    const fine = canvas.width / camera.width / (isMoving ? 2 : 1);
    const [width, height] = [Math.max(1, Math.round(camera.width * fine)), Math.max(1, Math.round(camera.height * fine))];
    const isCoarse = isMoving && scene.triangles.length / 3 > MANY;
    if (isCoarse) this.coarse ??= coarsened(scene, scene.bounds, MANY / 3);
    const { triangles, source } = isCoarse ? this.coarse : scene;
    const pixels = this.project(camera, fine);
    const depth = new Float32Array(width * height).fill(-Infinity);
    const number = new Int32Array(width * height).fill(-1);
    const image = new ImageData(width, height);
    const shades = new Uint32Array(image.data.buffer);
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
      const [ax, ay, az] = [pixels[a], pixels[a + 1], pixels[a + 2]];
      const [ux, uy, uz] = [pixels[b] - ax, pixels[b + 1] - ay, pixels[b + 2] - az];
      const [vx, vy, vz] = [pixels[c] - ax, pixels[c + 1] - ay, pixels[c + 2] - az];
      const area = ux * vy - uy * vx;
      if (!area) continue;
      const [left, right] = [Math.max(0, Math.ceil(ax + Math.min(0, ux, vx) - 0.5)), Math.min(width - 1, Math.floor(ax + Math.max(0, ux, vx) - 0.5))];
      const [top, bottom] = [Math.max(0, Math.ceil(ay + Math.min(0, uy, vy) - 0.5)), Math.min(height - 1, Math.floor(ay + Math.max(0, uy, vy) - 0.5))];
      if (left > right || top > bottom) continue;
      const own = source ? source[i / 3] : i / 3;
      // Depth is in pixels here, so that its slope is that of the triangle.
      const facing = Math.abs(area) / Math.hypot(area, ux * vz - uz * vx, uy * vz - uz * vy);
      const light = (0.45 + 0.55 * facing) * (area < 0 ? 1 : 0.6);
      const [red, green, blue] = look.ramp.slice(3 * this.steps[own], 3 * this.steps[own] + 3);
      const shade = (255 << 24) | ((255 * blue * light) << 16) | ((255 * green * light) << 8) | (255 * red * light);
      for (let y = top; y <= bottom; y++) {
        const dy = y + 0.5 - ay;
        for (let x = left; x <= right; x++) {
          const dx = x + 0.5 - ax;
          const s = (dx * vy - dy * vx) / area;
          const t = (ux * dy - uy * dx) / area;
          if (s < 0 || t < 0 || s + t > 1) continue;
          const z = az + s * uz + t * vz;
          const at = y * width + x;
          if (z <= depth[at]) continue;
          depth[at] = z;
          number[at] = own;
          shades[at] = shade;
        }
      }
    }
    if (fine * scene.meanEdge * camera.scale >= EDGE_ROOM && !isCoarse) this.outline(shades, number, width, height, look);
    const { context } = this;
    const drawn = new OffscreenCanvas(width, height);
    drawn.getContext("2d").putImageData(image, 0, 0);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(drawn, 0, 0, canvas.width, canvas.height);
    if (look.hasDots && fine * scene.meanEdge * camera.scale >= DOT_ROOM && !isMoving) this.dots(context, pixels, depth, width, look);
  }

  /** All positions in pixels of the picture, with the depth in pixels, too. */
  project(camera, fine) {
    const pixels = projected(this.scene.positions, camera);
    const scales = [fine, fine, fine * camera.scale * camera.radius];
    for (let i = 0; i < pixels.length; i++) pixels[i] *= scales[i % 3];
    return pixels;
  }

  /** Darkens pixels where one triangle meets the next. */
  outline(shades, number, width, height, look) {
    const [red, green, blue] = look.edge.map((value) => 255 * value);
    const edge = (255 << 24) | (blue << 16) | (green << 8) | red;
    for (let y = 0; y + 1 < height; y++) {
      for (let x = 0; x + 1 < width; x++) {
        const at = y * width + x;
        if (number[at] >= 0 && (number[at] !== number[at + 1] || number[at] !== number[at + width])) shades[at] = edge;
      }
    }
  }

  dots(context, pixels, depth, width, look) {
    const { scene } = this;
    for (const vertex of scene.used) {
      const [x, y, z] = pixels.subarray(3 * vertex, 3 * vertex + 3);
      const [column, row] = [Math.floor(x), Math.floor(y)];
      if (column < 0 || column >= width || row < 0 || row * width + column >= depth.length) continue;
      if (depth[row * width + column] > z + 3) continue;
      context.fillStyle = degreeColor(scene.degrees[vertex]);
      context.fillRect(x - look.dot / 2, y - look.dot / 2, look.dot, look.dot);
    }
  }
}
