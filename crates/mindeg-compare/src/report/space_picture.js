// The picture of a mesh in space in a report: as a picture of a flat one to the rest of the page.

class SpacePicture {
  constructor(stage) {
    this.scene = methods[Number(stage.dataset.method)];
    this.stage = stage;
    const readout = stage.parentElement.querySelector(".readout");
    this.space = new SpaceStage(stage, this.scene, {
      told: (text, isSpoken) => {
        readout.textContent = text;
        if (isSpoken) element("spoken").textContent = text;
      },
      hasDots: () => element("dots").checked,
    });
    // The measure that the page colors.
    this.painter = this.space;
    this.space.color(measure);
    for (const button of stage.parentElement.querySelectorAll("[data-jump]")) {
      button.addEventListener("click", () => this.space.jump(button.dataset.jump));
    }
  }

  resize() {
    this.stage.style.aspectRatio = "1.6";
    this.space.resize();
  }

  draw() {
    this.space.look(colors);
    this.space.draw();
  }

  mark() {}

  shift() {
    this.draw();
  }
}
