// The picture of a mesh: the worker draws the mesh; what is marked, and the corners, are drawn here.
// From the viewer's script: Frame, aspectRatio, drawCross, drawnSize, followPointers, wantsStretch.

/** What all stages share: where they look. The points of a domain have places of their own. */
export const view = { x: 0, y: 0, zoom: 1, stretch: false };
export const bounds = { center: [0, 0], size: [1, 1] };

/** Pictures are at most so much wider than high: a corner needs room to be dragged outward. */
const LOWEST = 5.5;

export const isWide = () => !view.stretch && bounds.size[0] > 3 * bounds.size[1];

/** Looks at a whole domain. */
export function lookAtAll({ center, size }) {
  bounds.center = center;
  bounds.size = drawnSize(size);
  Object.assign(view, { x: center[0], y: center[1], zoom: 1 });
}

export const wantsStretchIn = (width) => wantsStretch(bounds.size, width);

export class Stage {
  constructor(figure, hooks) {
    this.figure = figure;
    /** `main` or `beside`; what it shows is its `view`. */
    this.id = figure.dataset.stage;
    this.view = null;
    this.element = figure.querySelector(".stage");
    this.frame = new Frame(bounds.size, view);
    [this.mesh, this.overlay] = this.element.querySelectorAll("canvas");
    this.readout = figure.querySelector(".readout");
    this.worst = null;
    followPointers(this.element, { frame: this.frame, ...hooks(this) });
  }

  /** Takes the size that it has on the page; whether that is another than before. */
  resize() {
    this.frame.size = bounds.size;
    this.element.style.aspectRatio = String(Math.min(LOWEST, aspectRatio(bounds.size, view.stretch)));
    const { width, height } = this.element.getBoundingClientRect();
    const dots = window.devicePixelRatio || 1;
    if (width === this.frame.width && height === this.frame.height && dots === this.frame.dots) return false;
    Object.assign(this.frame, { width, height, dots });
    this.overlay.width = Math.round(width * dots);
    this.overlay.height = Math.round(height * dots);
    return true;
  }

  /** What the worker needs to know to draw it. */
  get size() {
    const { width, height, dots } = this.frame;
    return { width, height, dots };
  }

  line(context, corners, isClosed) {
    context.beginPath();
    for (const corner of corners) context.lineTo(...this.frame.toScreen(...corner));
    if (isClosed) context.closePath();
    context.stroke();
  }

  /** Marks the thinnest triangle, what is pointed at, and what decides. */
  mark(colors, { cursor, found, decides }) {
    const { frame } = this;
    if (!frame.width) return null;
    const context = frame.start(this.overlay);
    context.lineJoin = "round";
    context.strokeStyle = colors.mark;
    if (this.worst) {
      context.lineWidth = 2.5;
      this.line(context, this.worst, true);
    }
    context.lineWidth = 3;
    for (const corner of decides) {
      context.beginPath();
      context.arc(...frame.toScreen(...corner), 12, 0, 2 * Math.PI);
      context.stroke();
    }
    this.readout.textContent = found?.text ?? "";
    if (cursor && found?.corners.length) {
      context.lineWidth = 2;
      if (found.corners.length > 1) this.line(context, found.corners, true);
      else {
        context.beginPath();
        context.arc(...frame.toScreen(...found.corners[0]), 8, 0, 2 * Math.PI);
        context.stroke();
      }
    }
    if (cursor && (cursor.from !== this || cursor.centered)) drawCross(context, frame.toScreen(cursor.x, cursor.y));
    return context;
  }
}
