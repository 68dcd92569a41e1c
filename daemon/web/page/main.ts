import './style.css';
document.body.append('TP100 cockpit');
