// The picture of one mesh in a report.

class Picture {
  constructor(stage) {
    this.stage = stage;
    this.scene = methods[Number(stage.dataset.method)];
    this.frame = new Frame(size, view);
    this.painter = new Painter(this.scene, measure);
    [this.mesh, this.overlay] = stage.querySelectorAll("canvas");
    this.readout = stage.parentElement.querySelector(".readout");
    followPointers(stage, {
      frame: this.frame,
      pointAt: (x, y) => setCursor({ x, y, from: this }),
      leave: () => setCursor(null),
      pointAtCenter: () => this.pointAtCenter(),
      moveTo,
      zoomBy: (factor, place) => zoomBy(factor, this, place),
      fit,
    });
    for (const button of stage.parentElement.querySelectorAll("[data-jump]")) {
      button.addEventListener("click", () => this.jump(button.dataset.jump));
    }
  }

  resize() {
    this.stage.style.aspectRatio = String(aspectRatio(size, view.stretch));
    const box = this.stage.getBoundingClientRect();
    const dots = window.devicePixelRatio || 1;
    Object.assign(this.frame, { width: box.width, height: box.height, dots });
    for (const canvas of [this.mesh, this.overlay]) {
      canvas.width = Math.round(box.width * dots);
      canvas.height = Math.round(box.height * dots);
    }
  }

  draw() {
    // In a part of the page that is folded away.
    if (!this.frame.width) return;
    this.mesh.style.transform = "";
    this.drawn = { ...view, scale: this.frame.scale() };
    this.painter.paint(this.frame.start(this.mesh), this.frame, colors, element("dots").checked);
  }

  /** Moves and scales what is drawn to where it belongs now. */
  shift() {
    if (!this.drawn) return;
    const [sx, sy] = this.frame.scale();
    const { x, y, scale } = this.drawn;
    this.mesh.style.transform =
      `translate(${(x - view.x) * sx}px, ${(view.y - y) * sy}px) scale(${sx / scale[0]}, ${sy / scale[1]})`;
  }

  describe(x, y) {
    return describe(this.scene, measure, pick(this.scene, this.frame, x, y));
  }

  /** What is at the cursor: marked in the picture and put into words. */
  mark() {
    if (!this.frame.width) return;
    const context = this.frame.start(this.overlay);
    const found = cursor ? pick(this.scene, this.frame, cursor.x, cursor.y) : {};
    this.readout.textContent = describe(this.scene, measure, found);
    if (!cursor) return;
    context.strokeStyle = colors.mark;
    outlineFound(context, this.frame, this.scene, found);
    if (cursor.from === this && !cursor.centered) return;
    drawCross(context, this.frame.toScreen(cursor.x, cursor.y));
  }

  /** For those without a pointer, the middle of the picture is what is pointed at. */
  pointAtCenter() {
    setCursor({ x: view.x, y: view.y, from: this, centered: true });
    element("spoken").textContent = this.describe(view.x, view.y);
  }

  /** Shows a vertex of maximum degree, or the worst triangle as large as it goes. */
  jump(target) {
    const { worst, maxDegreeVertex } = this.scene;
    const { x, y, zoom } = lookAt(this.scene, this.frame, target === "worst" ? { triangle: worst } : { vertex: maxDegreeVertex });
    view.zoom = zoom;
    moveTo(x, y);
    setCursor({ x, y, from: this, centered: true });
    element("spoken").textContent = this.describe(x, y);
  }
}
