// A drawing (SVG) that can be enlarged and shifted: what part of the plane it shows is its viewBox.

const LARGEST = 60; // times
const SMALLEST = 0.5;

function zoomable(picture) {
  const { x, y, width, height } = picture.viewBox.baseVal;
  const whole = { x, y, width, height };
  let box = { ...whole };

  function show() {
    picture.setAttribute("viewBox", `${box.x} ${box.y} ${box.width} ${box.height}`);
  }
  function drag(right, down) {
    const scale = picture.getScreenCTM().a;
    box.x -= right / scale;
    box.y -= down / scale;
    show();
  }
  function zoom(factor, atX, atY) {
    const at = new DOMPoint(atX, atY).matrixTransform(picture.getScreenCTM().inverse());
    const width = Math.min(whole.width / SMALLEST, Math.max(whole.width / LARGEST, box.width / factor));
    const share = width / box.width;
    box = {
      x: at.x - share * (at.x - box.x),
      y: at.y - share * (at.y - box.y),
      width,
      height: share * box.height,
    };
    show();
  }
  function reset() {
    box = { ...whole };
    show();
  }
  return { drag, zoom, reset };
}
