// Live pages within a page: as tall as what they show, and as dark as what is around them.

addEventListener("message", ({ source, data }) => {
  for (const frame of document.querySelectorAll("iframe.live"))
    if (frame.contentWindow === source && data?.height > 0) frame.style.height = `${data.height}px`;
});
