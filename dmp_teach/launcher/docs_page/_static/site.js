// Live pages within a page are as tall as what they show.

addEventListener("message", ({ source, data }) => {
  for (const frame of document.querySelectorAll("iframe"))
    if (frame.contentWindow === source && data?.height > 0) frame.style.height = `${data.height}px`;
});
