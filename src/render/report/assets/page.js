// Starts the view in space. Before the page is printed it opens what is folded, and takes a picture of the view.

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
  if (!window.view) return;
  const root = document.getElementById("view");
  root.querySelector(".still").src = window.view.still();
  root.classList.add("pictured");
});
start();
