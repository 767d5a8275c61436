/** Buttons that copy the commands; without a clipboard a command is selected. */
function offerCopy() {
  for (const button of document.querySelectorAll(".copy")) {
    const command = button.parentElement.querySelector("code");
    button.hidden = false;
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(command.textContent);
        button.textContent = "Copied";
      } catch {
        getSelection().selectAllChildren(command);
      }
    });
  }
}
