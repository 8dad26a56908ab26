(() => {
  'use strict';
  const byId = id => document.getElementById(id);
  const viewer = byId('viewer');
  if (!viewer) return;
  const stage = byId('stage'), layers = [byId('layer-a'), byId('layer-b')];
  const tags = [byId('tag-a'), byId('tag-b')], choose = [byId('choose-a'), byId('choose-b')];
  const divide = byId('divide'), divider = byId('divider'), mode = byId('mode');
  let isMap = false;

  const show = () => {
    choose.forEach((select, i) => {
      layers[i].className = 'layer pixels ' + select.value.split(' ')[isMap ? 1 : 0];
      tags[i].textContent = select.selectedOptions[0].textContent;
    });
    layers[1].style.clipPath = `inset(0 0 0 ${divide.value}%)`;
    divider.style.left = divide.value + '%';
    mode.setAttribute('aria-pressed', isMap);
  };
  const flip = () => {
    // In the middle both are seen, and change sides; at an end one covers the other, and the other is seen next.
    if (divide.value > 5 && divide.value < 95) {
      [choose[0].value, choose[1].value] = [choose[1].value, choose[0].value];
    } else {
      divide.value = divide.value > 50 ? 0 : 100;
    }
    show();
  };
  const turn = () => { isMap = !isMap; show(); };
  const drag = event => {
    const box = stage.getBoundingClientRect();
    divide.value = Math.max(0, Math.min(100, 100 * (event.clientX - box.left) / box.width));
    show();
  };

  choose[1].selectedIndex = Math.min(1, choose[1].length - 1);
  choose.forEach(select => select.addEventListener('change', show));
  divide.addEventListener('input', show);
  byId('flip').addEventListener('click', flip);
  mode.addEventListener('click', turn);
  stage.addEventListener('pointerdown', event => { stage.setPointerCapture(event.pointerId); drag(event); });
  stage.addEventListener('pointermove', event => { if (event.buttons) drag(event); });
  stage.addEventListener('keydown', event => {
    const step = { ArrowLeft: -2, ArrowRight: 2 }[event.key];
    if (step) divide.value = +divide.value + step;
    else if (event.key === ' ') flip();
    else if (event.key === 'm') turn();
    else return;
    event.preventDefault();
    show();
  });
  for (const figure of document.querySelectorAll('[data-view]')) {
    const view = () => {
      choose[1].value = figure.dataset.view;
      show();
      viewer.scrollIntoView({ behavior: 'smooth', block: 'nearest' });
    };
    figure.addEventListener('click', view);
    figure.addEventListener('keydown', event => { if (event.key === 'Enter') view(); });
  }
  viewer.hidden = false;
  show();
})();
