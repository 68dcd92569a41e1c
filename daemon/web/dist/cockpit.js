document.body.append("TP100 cockpit");
