// Starts the view in space, and opens what is folded before the page is printed.

async function start() {
  const root = document.getElementById("view");
  const told = root.querySelector('[data-control="told"]');
  try {
    const read = (id) => document.getElementById(id).textContent;
    const header = JSON.parse(read("header"));
    const bytes = await inflate(read("arrays"));
    window.view = new View(root, readModel(header, bytes), header.colours);
    root.dataset.ready = "true";
  } catch (error) {
    root.classList.add("failed");
    told.textContent = `No view in space: ${error.message}. The pictures below show the same.`;
  }
}

addEventListener("beforeprint", () => {
  document.querySelectorAll("details").forEach((details) => (details.open = true));
});
start();
