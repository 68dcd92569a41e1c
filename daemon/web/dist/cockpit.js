var dS=Object.create;var w0=Object.defineProperty;var fS=Object.getOwnPropertyDescriptor;var pS=Object.getOwnPropertyNames;var mS=Object.getPrototypeOf,gS=Object.prototype.hasOwnProperty;var Bn=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var _S=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of pS(e))!gS.call(i,s)&&s!==t&&w0(i,s,{get:()=>e[s],enumerable:!(n=fS(e,s))||n.enumerable});return i};var vS=(i,e,t)=>(t=i!=null?dS(mS(i)):{},_S(e||!i||!i.__esModule?w0(t,"default",{value:i,enumerable:!0}):t,i));var gu=Bn(ra=>{"use strict";Object.defineProperty(ra,"__esModule",{value:!0});ra.toKeyName=ra.last=void 0;function lC(i){var e;return(e=i[i.length-1])!==null&&e!==void 0?e:null}ra.last=lC;function cC(i){return i.type==="TOMLBare"?i.name:i.value}ra.toKeyName=cC});var am=Bn(yu=>{"use strict";Object.defineProperty(yu,"__esModule",{value:!0});yu.getTOMLVer=void 0;var vu=class{constructor(e,t){this.major=e,this.minor=t}lt(e,t){return this.major<e||this.major===e&&this.minor<t}gte(e,t){return this.major>e||this.major===e&&this.minor>=t}},_u=new vu(1,0),om=new vu(1,1),hC=_u,uC={"1.0":_u,"1.0.0":_u,"1.1":om,"1.1.0":om,latest:_u,next:om};function dC(i){return uC[i||"latest"]||hC}yu.getTOMLVer=dC});var bu=Bn(xu=>{"use strict";Object.defineProperty(xu,"__esModule",{value:!0});xu.ParseError=void 0;var kv={"unterminated-string":"Unterminated string constant","unterminated-table-key":"Unterminated table-key","unterminated-array":"Unterminated array","unterminated-inline-table":"Unterminated inline table","missing-key":"Empty bare keys are not allowed","missing-newline":"Must be a newline","missing-equals-sign":"Expected equal (=) token","missing-value":"Unspecified values are invalid","missing-comma":"Expected comma (,) token","dupe-keys":"Defining a key multiple times is invalid","unexpected-char":"Unexpected character","unexpected-token":"Unexpected token","invalid-control-character":"Control characters (codes < 0x1f and 0x7f) are not allowed","invalid-comment-character":"Invalid code point {{cp}} within comments","invalid-key-value-newline":"The key, equals sign, and value must be on the same line","invalid-inline-table-newline":"No newlines are allowed between the curly braces unless they are valid within a value","invalid-underscore":"Underscores are allowed between digits","invalid-space":"Unexpected spaces","invalid-three-quotes":"Three or more quotes are not permitted","invalid-date":"Unexpected invalid date","invalid-time":"Unexpected invalid time","invalid-leading-zero":"Leading zeros are not allowed","invalid-trailing-comma-in-inline-table":"Trailing comma is not permitted in an inline table","invalid-char-in-escape-sequence":"Invalid character in escape sequence","invalid-code-point":"Invalid code point {{cp}}"};function fC(i,e){return e?kv[i].replace(/\{\{(.*?)\}\}/gu,(t,n)=>n in e?e[n]:`{{${n}}}`):kv[i]}var lm=class extends SyntaxError{constructor(e,t,n,s,r){super(fC(e,r)),this.index=t,this.lineNumber=n,this.column=s}};xu.ParseError=lm});var Dv=Bn(wu=>{"use strict";Object.defineProperty(wu,"__esModule",{value:!0});wu.Locations=void 0;function pC(i,e){let t=0,n=i.length;for(;t<n;){let s=t+n>>>1,r=i[s];if(r===e)return s+1;r<e?t=s+1:n=s}return t}var cm=class{constructor(){this.offsets=[]}addOffset(e){for(let t=this.offsets.length-1;t>=0;t--){let n=this.offsets[t];if(n===e)return;if(n<e)break}this.offsets.push(e)}getLocFromIndex(e){let t=pC(this.offsets,e)+1,n=e-(t===1?0:this.offsets[t-2]);return{line:t,column:n}}};wu.Locations=cm});var Nv=Bn(Su=>{"use strict";Object.defineProperty(Su,"__esModule",{value:!0});Su.CodePointIterator=void 0;var mC=Dv(),hm=class{constructor(e){this.locs=new mC.Locations,this.lastCodePoint=0,this.start=-1,this.end=0,this.text=e}next(){return this.lastCodePoint===-1?-1:this.lastCodePoint=this.moveAt(this.end)}getStartLoc(){return this.getLocFromIndex(this.start)}getEndLoc(){return this.getLocFromIndex(this.end)}getLocFromIndex(e){return this.locs.getLocFromIndex(e)}eat(e){return this.text.codePointAt(this.end)===e?(this.next(),!0):!1}moveAt(e){var t;this.start=this.end=e;let n=(t=this.text.codePointAt(this.start))!==null&&t!==void 0?t:-1;if(n===-1)return this.end=this.start,n;let s=n>=65536?2:1;if(this.end+=s,n===10)this.locs.addOffset(this.end);else if(n===13)return this.text.codePointAt(this.end)===10&&(this.end++,this.locs.addOffset(this.end)),10;return n}};Su.CodePointIterator=hm});var Uv=Bn(cn=>{"use strict";Object.defineProperty(cn,"__esModule",{value:!0});cn.isUnicodeScalarValue=cn.isLowSurrogate=cn.isHighSurrogate=cn.isOctalDig=cn.isHexDig=cn.isDigit=cn.isLetter=cn.isEOL=cn.isWhitespace=cn.isControl=void 0;function gC(i){return i>=0&&i<=31}cn.isControl=gC;function _C(i){return i===9||i===32}cn.isWhitespace=_C;function vC(i){return i===10||i===13}cn.isEOL=vC;function yC(i){return i>=65&&i<=90}function xC(i){return i>=97&&i<=122}function bC(i){return xC(i)||yC(i)}cn.isLetter=bC;function Ov(i){return i>=48&&i<=57}cn.isDigit=Ov;function wC(i){return Ov(i)||i>=97&&i<=102||i>=65&&i<=70}cn.isHexDig=wC;function SC(i){return i>=48&&i<=55}cn.isOctalDig=SC;function MC(i){return i>=55296&&i<=57343}cn.isHighSurrogate=MC;function TC(i){return i>=56320&&i<=57343}cn.isLowSurrogate=TC;function EC(i){return i>=0&&i<=55295||i>=57344&&i<=1114111}cn.isUnicodeScalarValue=EC});var zv=Bn(Mu=>{"use strict";Object.defineProperty(Mu,"__esModule",{value:!0});Mu.Tokenizer=void 0;var AC=bu(),CC=am(),PC=Nv(),gt=Uv(),RC=typeof BigInt<"u",LC={16:"0x",10:"",8:"0o",2:"0b"},Bv={34:34,92:92,98:8,102:12,110:10,114:13,116:9},IC=Object.assign(Object.assign({},Bv),{101:27}),dm=class{constructor(e,t){this.backCode=!1,this.lastCodePoint=0,this.state="DATA",this.token=null,this.tokenStart=-1,this.valuesEnabled=!1,this.text=e,this.parserOptions=t||{},this.codePointIterator=new PC.CodePointIterator(e),this.tomlVersion=(0,CC.getTOMLVer)(this.parserOptions.tomlVersion),this.ESCAPES=this.tomlVersion.gte(1,1)?IC:Bv}get positions(){return{start:Object.assign(Object.assign({},this.codePointIterator.getStartLoc()),{offset:this.codePointIterator.start}),end:Object.assign(Object.assign({},this.codePointIterator.getEndLoc()),{offset:this.codePointIterator.end})}}reportParseError(e,t){let n=this.codePointIterator.getStartLoc();throw new AC.ParseError(e,this.codePointIterator.start,n.line,n.column,t)}nextToken(){let e=this.token;if(e!=null)return this.token=null,e;let t=this.lastCodePoint;for(;t!==-1&&!this.token;){t=this.nextCode();let n=this[this.state](t);if(!n)throw new Error(`Unknown error: pre state=${this.state}`);this.state=n}return e=this.token,this.token=null,e}nextCode(){return this.lastCodePoint===-1?-1:this.backCode?(this.backCode=!1,this.lastCodePoint):this.lastCodePoint=this.codePointIterator.next()}eatCode(e){return this.lastCodePoint===-1?!1:this.backCode?this.lastCodePoint===e?(this.backCode=!1,!0):!1:this.codePointIterator.eat(e)}moveAt(e){this.backCode&&(this.backCode=!1),this.lastCodePoint=this.codePointIterator.moveAt(e)}back(e){return this.backCode=!0,e}punctuatorToken(){this.startToken(),this.endToken("Punctuator","end")}startToken(){this.tokenStart=this.codePointIterator.start}endToken(e,t,n,s){let{tokenStart:r}=this,o=this.codePointIterator[t],a=[r,o],l={start:this.codePointIterator.getLocFromIndex(r),end:this.codePointIterator.getLocFromIndex(o)};if(e==="Block")this.token={type:e,value:this.text.slice(r+1,o),range:a,loc:l};else{let c,h=this.text.slice(r,o);if(e==="BasicString"||e==="LiteralString"||e==="MultiLineBasicString"||e==="MultiLineLiteralString")c={type:e,value:h,string:n,range:a,loc:l};else if(e==="Integer"){let u=n;c={type:e,value:h,number:parseInt(u,s),bigint:RC?BigInt(LC[s]+u):null,range:a,loc:l}}else e==="Float"?c={type:e,value:h,number:n,range:a,loc:l}:e==="Boolean"?c={type:e,value:h,boolean:n,range:a,loc:l}:e==="LocalDate"||e==="LocalTime"||e==="LocalDateTime"||e==="OffsetDateTime"?c={type:e,value:h,date:n,range:a,loc:l}:c={type:e,value:h,range:a,loc:l};this.token=c}}DATA(e){for(;(0,gt.isWhitespace)(e)||(0,gt.isEOL)(e);)e=this.nextCode();if(e===35)return this.startToken(),"COMMENT";if(e===34)return this.startToken(),"BASIC_STRING";if(e===39)return this.startToken(),"LITERAL_STRING";if(e===46||e===61||e===91||e===93||e===123||e===125||e===44)return this.punctuatorToken(),"DATA";if(this.valuesEnabled){if(e===45||e===43)return this.startToken(),"SIGN";if(e===110||e===105)return this.startToken(),this.back("NAN_OR_INF");if((0,gt.isDigit)(e))return this.startToken(),this.back("NUMBER");if(e===116||e===102)return this.startToken(),this.back("BOOLEAN")}else if(Fv(e,this.tomlVersion))return this.startToken(),"BARE";return e===-1?"DATA":this.reportParseError("unexpected-char")}COMMENT(e){let t=this.tomlVersion.gte(1,1)?n=>{kC(n)||this.reportParseError("invalid-comment-character")}:n=>{Il(n)&&this.reportParseErrorControlChar()};for(;!(0,gt.isEOL)(e)&&e!==-1;)t(e),e=this.nextCode();return this.endToken("Block","start"),"DATA"}BARE(e){for(;Fv(e,this.tomlVersion);)e=this.nextCode();return this.endToken("Bare","start"),this.back("DATA")}BASIC_STRING(e){if(e===34)return e=this.nextCode(),e===34?"MULTI_LINE_BASIC_STRING":(this.endToken("BasicString","start",""),this.back("DATA"));let t=[];for(;e!==34&&e!==-1&&e!==10;){if(Il(e))return this.reportParseErrorControlChar();if(e===92){e=this.nextCode();let n=this.ESCAPES[e];if(n){t.push(n),e=this.nextCode();continue}else if(e===117){let s=this.parseUnicode(4);t.push(s),e=this.nextCode();continue}else if(e===85){let s=this.parseUnicode(8);t.push(s),e=this.nextCode();continue}else if(e===120&&this.tomlVersion.gte(1,1)){let s=this.parseUnicode(2);t.push(s),e=this.nextCode();continue}return this.reportParseError("invalid-char-in-escape-sequence")}t.push(e),e=this.nextCode()}return e!==34?this.reportParseError("unterminated-string"):(this.endToken("BasicString","end",String.fromCodePoint(...t)),"DATA")}MULTI_LINE_BASIC_STRING(e){let t=[];for(e===10&&(e=this.nextCode());e!==-1;){if(e!==10&&Il(e))return this.reportParseErrorControlChar();if(e===34){let n=this.codePointIterator.start;if(this.eatCode(34)&&this.eatCode(34))return this.eatCode(34)&&(t.push(34),this.eatCode(34)&&(t.push(34),this.eatCode(34)))?(this.moveAt(n),this.reportParseError("invalid-three-quotes")):(this.endToken("MultiLineBasicString","end",String.fromCodePoint(...t)),"DATA");this.moveAt(n)}if(e===92){e=this.nextCode();let n=this.ESCAPES[e];if(n){t.push(n),e=this.nextCode();continue}else if(e===117){let s=this.parseUnicode(4);t.push(s),e=this.nextCode();continue}else if(e===85){let s=this.parseUnicode(8);t.push(s),e=this.nextCode();continue}else if(e===120&&this.tomlVersion.gte(1,1)){let s=this.parseUnicode(2);t.push(s),e=this.nextCode();continue}else if(e===10){for(e=this.nextCode();(0,gt.isWhitespace)(e)||e===10;)e=this.nextCode();continue}else if((0,gt.isWhitespace)(e)){let s=!0,r=this.codePointIterator.start,o;for(;(o=this.nextCode())!==-1&&o!==10;)if(!(0,gt.isWhitespace)(o)){this.moveAt(r),s=!1;break}if(s){for(e=this.nextCode();(0,gt.isWhitespace)(e)||e===10;)e=this.nextCode();continue}}return this.reportParseError("invalid-char-in-escape-sequence")}t.push(e),e=this.nextCode()}return this.reportParseError("unterminated-string")}LITERAL_STRING(e){if(e===39)return e=this.nextCode(),e===39?"MULTI_LINE_LITERAL_STRING":(this.endToken("LiteralString","start",""),this.back("DATA"));let t=[];for(;e!==39&&e!==-1&&e!==10;){if(Il(e))return this.reportParseErrorControlChar();t.push(e),e=this.nextCode()}return e!==39?this.reportParseError("unterminated-string"):(this.endToken("LiteralString","end",String.fromCodePoint(...t)),"DATA")}MULTI_LINE_LITERAL_STRING(e){let t=[];for(e===10&&(e=this.nextCode());e!==-1;){if(e!==10&&Il(e))return this.reportParseErrorControlChar();if(e===39){let n=this.codePointIterator.start;if(this.eatCode(39)&&this.eatCode(39))return this.eatCode(39)&&(t.push(39),this.eatCode(39)&&(t.push(39),this.eatCode(39)))?(this.moveAt(n),this.reportParseError("invalid-three-quotes")):(this.endToken("MultiLineLiteralString","end",String.fromCodePoint(...t)),"DATA");this.moveAt(n)}t.push(e),e=this.nextCode()}return this.reportParseError("unterminated-string")}SIGN(e){return e===110||e===105?this.back("NAN_OR_INF"):(0,gt.isDigit)(e)?this.back("NUMBER"):this.reportParseError("unexpected-char")}NAN_OR_INF(e){if(e===110){let t=this.codePointIterator.start;if(this.eatCode(97)&&this.eatCode(110))return this.endToken("Float","end",NaN),"DATA";this.moveAt(t)}else if(e===105){let t=this.codePointIterator.start;if(this.eatCode(110)&&this.eatCode(102))return this.endToken("Float","end",this.text[this.tokenStart]==="-"?-1/0:1/0),"DATA";this.moveAt(t)}return this.reportParseError("unexpected-char")}NUMBER(e){let t=this.text[this.tokenStart],n=t==="+"?43:t==="-"?45:0;if(e===48){if(n===0){let a=this.codePointIterator.start,l=this.nextCode();if((0,gt.isDigit)(l)){let c=this.nextCode();if(c===58){let h={hasDate:!1,year:0,month:0,day:0,hour:Number(String.fromCodePoint(48,l)),minute:0,second:0};return this.data=h,"TIME_MINUTE"}if((0,gt.isDigit)(c)){let h=this.nextCode();if((0,gt.isDigit)(h)&&this.eatCode(45)){let u={hasDate:!0,year:Number(String.fromCodePoint(48,l,c,h)),month:0,day:0,hour:0,minute:0,second:0};return this.data=u,"DATE_MONTH"}}return this.moveAt(a),this.reportParseError("invalid-leading-zero")}this.moveAt(a)}if(e=this.nextCode(),e===120||e===111||e===98)return n!==0?this.reportParseError("unexpected-char"):e===120?"HEX":e===111?"OCTAL":"BINARY";if(e===101||e===69){let a={minus:n===45,left:[48]};return this.data=a,"EXPONENT_RIGHT"}if(e===46){let a={minus:n===45,absInt:[48]};return this.data=a,"FRACTIONAL_RIGHT"}return this.endToken("Integer","start","0",10),this.back("DATA")}let{out:s,nextCp:r,hasUnderscore:o}=this.parseDigits(e,gt.isDigit);if(r===45&&n===0&&!o&&s.length===4){let a={hasDate:!0,year:Number(String.fromCodePoint(...s)),month:0,day:0,hour:0,minute:0,second:0};return this.data=a,"DATE_MONTH"}if(r===58&&n===0&&!o&&s.length===2){let a={hasDate:!1,year:0,month:0,day:0,hour:Number(String.fromCodePoint(...s)),minute:0,second:0};return this.data=a,"TIME_MINUTE"}if(r===101||r===69){let a={minus:n===45,left:s};return this.data=a,"EXPONENT_RIGHT"}if(r===46){let a={minus:n===45,absInt:s};return this.data=a,"FRACTIONAL_RIGHT"}return this.endToken("Integer","start",n===45?String.fromCodePoint(45,...s):String.fromCodePoint(...s),10),this.back("DATA")}HEX(e){let{out:t}=this.parseDigits(e,gt.isHexDig);return this.endToken("Integer","start",String.fromCodePoint(...t),16),this.back("DATA")}OCTAL(e){let{out:t}=this.parseDigits(e,gt.isOctalDig);return this.endToken("Integer","start",String.fromCodePoint(...t),8),this.back("DATA")}BINARY(e){let{out:t}=this.parseDigits(e,n=>n===48||n===49);return this.endToken("Integer","start",String.fromCodePoint(...t),2),this.back("DATA")}FRACTIONAL_RIGHT(e){let{minus:t,absInt:n}=this.data,{out:s,nextCp:r}=this.parseDigits(e,gt.isDigit),o=[...n,46,...s];if(r===101||r===69){let l={minus:t,left:o};return this.data=l,"EXPONENT_RIGHT"}let a=Number(t?String.fromCodePoint(45,...o):String.fromCodePoint(...o));return this.endToken("Float","start",a),this.back("DATA")}EXPONENT_RIGHT(e){let{left:t,minus:n}=this.data,s=!1;(e===45||e===43)&&(s=e===45,e=this.nextCode());let{out:r}=this.parseDigits(e,gt.isDigit),o=r;s&&o.unshift(45);let a=Number(n?String.fromCodePoint(45,...t,101,...o):String.fromCodePoint(...t,101,...o));return this.endToken("Float","start",a),this.back("DATA")}BOOLEAN(e){if(e===116){let t=this.codePointIterator.start;if(this.eatCode(114)&&this.eatCode(117)&&this.eatCode(101))return this.endToken("Boolean","end",!0),"DATA";this.moveAt(t)}else if(e===102){let t=this.codePointIterator.start;if(this.eatCode(97)&&this.eatCode(108)&&this.eatCode(115)&&this.eatCode(101))return this.endToken("Boolean","end",!1),"DATA";this.moveAt(t)}return this.reportParseError("unexpected-char")}DATE_MONTH(e){let t=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==45)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start,s=this.data;return s.month=Number(this.text.slice(t,n)),"DATE_DAY"}DATE_DAY(e){let t=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;if(s.day=Number(this.text.slice(t,n)),!NC(s.year,s.month,s.day))return this.reportParseError("invalid-date");if(e=this.nextCode(),e===84||e===116)return"TIME_HOUR";if(e===32){let o=this.codePointIterator.start;if((0,gt.isDigit)(this.nextCode())&&(0,gt.isDigit)(this.nextCode()))return this.moveAt(o),"TIME_HOUR";this.moveAt(o)}let r=kl(s,"");return this.endToken("LocalDate","start",r),this.back("DATA")}TIME_HOUR(e){let t=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==58)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start,s=this.data;return s.hour=Number(this.text.slice(t,n)),"TIME_MINUTE"}TIME_MINUTE(e){let t=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;return s.minute=Number(this.text.slice(t,n)),e=this.nextCode(),e===58?"TIME_SECOND":this.tomlVersion.lt(1,1)?this.reportParseError("unexpected-char"):um(s.hour,s.minute,s.second)?this.processTimeEnd(e,s):this.reportParseError("invalid-time")}TIME_SECOND(e){let t=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let n=this.codePointIterator.end,s=this.data;return s.second=Number(this.text.slice(t,n)),um(s.hour,s.minute,s.second)?(e=this.nextCode(),e===46?"TIME_SEC_FRAC":this.processTimeEnd(e,s)):this.reportParseError("invalid-time")}TIME_SEC_FRAC(e){if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let t=this.codePointIterator.start;for(;(0,gt.isDigit)(e);)e=this.nextCode();let n=this.codePointIterator.start,s=this.data;return s.frac=this.text.slice(t,n),this.processTimeEnd(e,s)}processTimeEnd(e,t){if(t.hasDate){if(e===45||e===43)return t.offsetSign=e,"TIME_OFFSET";if(e===90||e===122){let r=kl(t,"Z");return this.endToken("OffsetDateTime","end",r),"DATA"}let s=kl(t,"");return this.endToken("LocalDateTime","start",s),this.back("DATA")}let n=kl(t,"");return this.endToken("LocalTime","start",n),this.back("DATA")}TIME_OFFSET(e){if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let t=this.codePointIterator.start;if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),e!==58)return this.reportParseError("unexpected-char");let n=this.codePointIterator.start;e=this.nextCode();let s=this.codePointIterator.start;if(!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");if(e=this.nextCode(),!(0,gt.isDigit)(e))return this.reportParseError("unexpected-char");let r=this.codePointIterator.end,o=Number(this.text.slice(t,n)),a=Number(this.text.slice(s,r));if(!um(o,a,0))return this.reportParseError("invalid-time");let l=this.data,c=kl(l,`${String.fromCodePoint(l.offsetSign)}${br(o,2)}:${br(a,2)}`);return this.endToken("OffsetDateTime","end",c),"DATA"}parseDigits(e,t){if(e===95)return this.reportParseError("invalid-underscore");if(!t(e))return this.reportParseError("unexpected-char");let n=[],s=0,r=!1;for(;t(e)||e===95;){if(e===95){if(r=!0,s===95)return this.reportParseError("invalid-underscore")}else n.push(e);s=e,e=this.nextCode()}return s===95?this.reportParseError("invalid-underscore"):{out:n,nextCp:e,hasUnderscore:r}}parseUnicode(e){let t=this.codePointIterator.start,n=this.codePointIterator.end,s=0,r;for(;(r=this.nextCode())!==-1;){if(!(0,gt.isHexDig)(r))return this.moveAt(t),this.reportParseError("invalid-char-in-escape-sequence");if(s++,s>=e)break}let o=this.codePointIterator.end,a=this.text.slice(n,o),l=parseInt(a,16);return(0,gt.isUnicodeScalarValue)(l)?l:this.reportParseError("invalid-code-point",{cp:a})}reportParseErrorControlChar(){return this.reportParseError("invalid-control-character")}};Mu.Tokenizer=dm;function Fv(i,e){return(0,gt.isLetter)(i)||(0,gt.isDigit)(i)||i===95||i===45?!0:e.lt(1,1)?!1:i===178||i===179||i===185||188<=i&&i<=190||192<=i&&i<=214||216<=i&&i<=246||248<=i&&i<=891||895<=i&&i<=8191||8204<=i&&i<=8205||8255<=i&&i<=8256||8304<=i&&i<=8591||9312<=i&&i<=9471||11264<=i&&i<=12271||12289<=i&&i<=55295||63744<=i&&i<=64975||65008<=i&&i<=65533||65536<=i&&i<=983039}function Il(i){return(0,gt.isControl)(i)&&i!==9||i===127}function kC(i){return 1<=i&&i<=9||14<=i&&i<=127||DC(i)}function DC(i){return 128<=i&&i<=55295||57344<=i&&i<=1114111}function NC(i,e,t){if(i>=0&&e<=12&&e>=1&&t>=1){let n=e===2?i&3||!(i%25)&&i&15?28:29:30+(e+(e>>3)&1);return t<=n}return!1}function um(i,e,t){return!(i>=24||i<0||e>59||e<0||t>60||t<0)}function kl(i,e){let t=br(i.year,4),n=i.month?br(i.month,2):"01",s=i.day?br(i.day,2):"01",r=br(i.hour,2),o=br(i.minute,2),a=br(i.second,2),l=`${t}-${n}-${s}`,c=i.frac?`.${i.frac}`:"",h=new Date(`${l}T${r}:${o}:${a}${c}${e}`);return!isNaN(h.getTime())||i.second!==60?h:new Date(`${l}T${r}:${o}:59${c}${e}`)}function br(i,e){return String(i).padStart(e,"0")}});var Vv=Bn(qr=>{"use strict";var OC=qr&&qr.__createBinding||(Object.create?(function(i,e,t,n){n===void 0&&(n=t);var s=Object.getOwnPropertyDescriptor(e,t);(!s||("get"in s?!e.__esModule:s.writable||s.configurable))&&(s={enumerable:!0,get:function(){return e[t]}}),Object.defineProperty(i,n,s)}):(function(i,e,t,n){n===void 0&&(n=t),i[n]=e[t]})),UC=qr&&qr.__exportStar||function(i,e){for(var t in i)t!=="default"&&!Object.prototype.hasOwnProperty.call(e,t)&&OC(e,i,t)};Object.defineProperty(qr,"__esModule",{value:!0});UC(zv(),qr)});var Wv=Bn(Au=>{"use strict";Object.defineProperty(Au,"__esModule",{value:!0});Au.KeysResolver=void 0;var Eu=gu(),fm=class{constructor(e){this.rootKeys=new Map,this.tables=[],this.ctx=e}applyResolveKeyForTable(e){let t=this.rootKeys,n=e.key.keys.length-1;for(let a=0;a<n;a++){let l=e.key.keys[a],c=(0,Eu.toKeyName)(l);e.resolvedKey.push(c);let h=t.get(c);if(!h)h={node:l,keys:new Map},t.set(c,h);else if(h.table==="array"){let u=h.peekIndex;e.resolvedKey.push(u),h=h.keys.get(u)}t=h.keys}let s=e.key.keys[n],r=(0,Eu.toKeyName)(s);e.resolvedKey.push(r);let o=t.get(r);if(o)if(o.table)if(o.table==="array")if(e.kind==="array"){let a={node:s,keys:new Map},l=o.peekIndex+1;e.resolvedKey.push(l),o.keys.set(l,a),o.peekIndex=l,this.tables.push({node:e,keys:a.keys})}else this.ctx.reportParseError("dupe-keys",s);else this.ctx.reportParseError("dupe-keys",s);else if(e.kind==="array")this.ctx.reportParseError("dupe-keys",s);else{let a={table:e.kind,node:s,keys:o.keys};t.set(r,a),this.tables.push({node:e,keys:a.keys})}else if(e.kind==="array"){e.resolvedKey.push(0);let a={node:s,keys:new Map};t.set(r,{table:e.kind,node:s,keys:new Map([[0,a]]),peekIndex:0}),this.tables.push({node:e,keys:a.keys})}else{let a={table:e.kind,node:s,keys:new Map};t.set(r,a),this.tables.push({node:e,keys:a.keys})}}verifyDuplicateKeys(e){for(let t of e.body)t.type==="TOMLKeyValue"&&pm(this.ctx,this.rootKeys,t);for(let{node:t,keys:n}of this.tables)for(let s of t.body)pm(this.ctx,n,s)}};Au.KeysResolver=fm;function pm(i,e,t){let n=e,s=(0,Eu.last)(t.key.keys);for(let r of t.key.keys){let o=(0,Eu.toKeyName)(r),a=n.get(o);a?((a.value===0||s===r||a.table)&&i.reportParseError("dupe-keys",Tu(r,a.node)),a.value=1):(s===r?a={value:0,node:r,keys:new Map}:a={value:1,node:r,keys:new Map},n.set(o,a)),n=a.keys}t.value.type==="TOMLInlineTable"?Hv(i,n,t.value):t.value.type==="TOMLArray"&&Gv(i,n,t.value)}function Hv(i,e,t){for(let n of t.body)pm(i,e,n)}function Gv(i,e,t){let n=e;for(let s=0;s<t.elements.length;s++){let r=t.elements[s],o=n.get(s);o?i.reportParseError("dupe-keys",Tu(r,o.node)):(o={value:0,node:r,keys:new Map},e.set(s,o),r.type==="TOMLInlineTable"?Hv(i,o.keys,r):r.type==="TOMLArray"&&Gv(i,o.keys,r))}}function Tu(i,e){return i.range[0]<=e.range[0]?e:i}});var Xv=Bn(Cu=>{"use strict";Object.defineProperty(Cu,"__esModule",{value:!0});Cu.Context=void 0;var FC=bu(),BC=Vv(),zC=Wv(),mm=class{constructor(e){this.tokens=[],this.comments=[],this.back=null,this.stateStack=[],this.needNewLine=!1,this.needSameLine=!1,this.currToken=null,this.prevToken=null,this.valueContainerStack=[],this.tokenizer=new BC.Tokenizer(e.text,e.parserOptions),this.topLevelTable=e.topLevelTable,this.table=e.topLevelTable,this.keysResolver=new zC.KeysResolver(this)}get startPos(){return this.tokenizer.positions.start}get endPos(){return this.tokenizer.positions.end}nextToken(e){if(this.prevToken=this.currToken,this.back?(this.currToken=this.back,this.back=null):this.currToken=this._nextTokenFromTokenizer(e),(this.needNewLine||this.needSameLine||e?.needSameLine)&&this.prevToken&&this.currToken)if(this.prevToken.loc.end.line===this.currToken.loc.start.line){if(this.needNewLine)return this.reportParseError("missing-newline",this.currToken)}else{let t=this.needSameLine||e?.needSameLine;if(t)return this.reportParseError(t,this.currToken)}return this.needNewLine=!1,this.needSameLine=!1,this.currToken}_nextTokenFromTokenizer(e){let t=this.tokenizer.valuesEnabled;e?.valuesEnabled&&(this.tokenizer.valuesEnabled=e.valuesEnabled);let n=this.tokenizer.nextToken();for(;n&&n.type==="Block";)this.comments.push(n),n=this.tokenizer.nextToken();return n&&this.tokens.push(n),this.tokenizer.valuesEnabled=t,n}backToken(){if(this.back)throw new Error("Illegal state");this.back=this.currToken,this.currToken=this.prevToken}addValueContainer(e){this.valueContainerStack.push(e),this.tokenizer.valuesEnabled=!0}consumeValueContainer(){let e=this.valueContainerStack.pop();return this.tokenizer.valuesEnabled=this.valueContainerStack.length>0,e}applyResolveKeyForTable(e){this.keysResolver.applyResolveKeyForTable(e)}verifyDuplicateKeys(){this.keysResolver.verifyDuplicateKeys(this.topLevelTable)}reportParseError(e,t){let n,s,r;if(t)n=t.range[0],s=t.loc.start.line,r=t.loc.start.column;else{let o=this.startPos;n=o.offset,s=o.line,r=o.column}throw new FC.ParseError(e,n,s,r)}};Cu.Context=mm});var Zv=Bn(Iu=>{"use strict";Object.defineProperty(Iu,"__esModule",{value:!0});Iu.TOMLParser=void 0;var Pu=gu(),VC=am(),HC=Xv(),$v={VALUE:"missing-value"},GC={BasicString:"basic",MultiLineBasicString:"basic",LiteralString:"literal",MultiLineLiteralString:"literal"},WC={BasicString:"basic",LiteralString:"literal"},XC={OffsetDateTime:"offset-date-time",LocalDateTime:"local-date-time",LocalDate:"local-date",LocalTime:"local-time"},vm=class{constructor(e,t){this.text=e,this.parserOptions=t||{},this.tomlVersion=(0,VC.getTOMLVer)(this.parserOptions.tomlVersion)}parse(){let e={type:"Program",body:[],sourceType:"module",tokens:[],comments:[],parent:null,range:[0,0],loc:{start:{line:1,column:0},end:{line:1,column:0}}},t={type:"TOMLTopLevelTable",body:[],parent:e,range:di(e.range),loc:fi(e.loc)};e.body=[t];let n=new HC.Context({text:this.text,parserOptions:this.parserOptions,topLevelTable:t}),s=n.nextToken();if(s){for(t.range[0]=s.range[0],t.loc.start=Lu(s.loc.start);s;){let a=n.stateStack.pop()||"TABLE";n.stateStack.push(...this[a](s,n)),s=n.nextToken()}let o=n.stateStack.pop()||"TABLE";if(o in $v)return n.reportParseError($v[o],null);n.table.type==="TOMLTable"&&ji(n.table,(0,Pu.last)(n.table.body)),ji(t,(0,Pu.last)(t.body))}n.verifyDuplicateKeys(),e.tokens=n.tokens,e.comments=n.comments;let r=n.endPos;return e.range[1]=r.offset,e.loc.end={line:r.line,column:r.column},e}TABLE(e,t){return Ru(e)||Nl(e)?this.processKeyValue(e,t.table,t):gm(e)?this.processTable(e,t.topLevelTable,t):t.reportParseError("unexpected-token",e)}VALUE(e,t){return Nl(e)||Kv(e)?this.processStringValue(e,t):YC(e)?this.processNumberValue(e,t):KC(e)?this.processBooleanValue(e,t):ZC(e)?this.processDateTimeValue(e,t):gm(e)?this.processArray(e,t):qC(e)?this.processInlineTable(e,t):t.reportParseError("unexpected-token",e)}processTable(e,t,n){let s={type:"TOMLTable",kind:"standard",key:null,resolvedKey:[],body:[],parent:t,range:di(e.range),loc:fi(e.loc)};n.table.type==="TOMLTable"&&ji(n.table,(0,Pu.last)(n.table.body)),t.body.push(s),n.table=s;let r=n.nextToken({needSameLine:"invalid-key-value-newline"});if(gm(r)){if(e.range[1]<r.range[0])return n.reportParseError("invalid-space",r);s.kind="array",r=n.nextToken({needSameLine:"invalid-key-value-newline"})}if(Dl(r))return n.reportParseError("missing-key",r);if(!r)return n.reportParseError("unterminated-table-key",null);if(r=this.processKeyNode(r,s,n).nextToken,!Dl(r))return n.reportParseError("unterminated-table-key",r);if(s.kind==="array"){let a=r;if(r=n.nextToken({needSameLine:"invalid-key-value-newline"}),!Dl(r))return n.reportParseError("unterminated-table-key",r);if(a.range[1]<r.range[0])return n.reportParseError("invalid-space",r)}return ji(s,r),n.applyResolveKeyForTable(s),n.needNewLine=!0,[]}processKeyValue(e,t,n){let s={type:"TOMLKeyValue",key:null,value:null,parent:t,range:di(e.range),loc:fi(e.loc)};t.body.push(s);let{nextToken:r}=this.processKeyNode(e,s,n);return qv(r)?(n.addValueContainer({parent:s,set:o=>(s.value=o,ji(s,o),n.needNewLine=!0,[])}),n.needSameLine="invalid-key-value-newline",["VALUE"]):n.reportParseError("missing-equals-sign",r)}processKeyNode(e,t,n){let s={type:"TOMLKey",keys:[],parent:t,range:di(e.range),loc:fi(e.loc)};t.key=s;let r=e;for(;r;){if(Ru(r))this.processBareKey(r,s);else if(Nl(r))this.processStringKey(r,s);else break;if(r=n.nextToken({needSameLine:"invalid-key-value-newline"}),$C(r))r=n.nextToken({needSameLine:"invalid-key-value-newline"});else break}return ji(s,(0,Pu.last)(s.keys)),{keyNode:s,nextToken:r}}processBareKey(e,t){let n={type:"TOMLBare",name:e.value,parent:t,range:di(e.range),loc:fi(e.loc)};t.keys.push(n)}processStringKey(e,t){let n={type:"TOMLQuoted",kind:"string",value:e.string,style:WC[e.type],multiline:!1,parent:t,range:di(e.range),loc:fi(e.loc)};t.keys.push(n)}processStringValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:"string",value:e.string,style:GC[e.type],multiline:Kv(e),parent:n.parent,range:di(e.range),loc:fi(e.loc)};return n.set(s)}processNumberValue(e,t){let n=t.consumeValueContainer(),s=this.text,[r,o]=e.range,a=null,l=()=>a??(a=s.slice(r,o).replace(/_/g,"")),c;return e.type==="Integer"?c={type:"TOMLValue",kind:"integer",value:e.number,bigint:e.bigint,get number(){return l()},parent:n.parent,range:di(e.range),loc:fi(e.loc)}:c={type:"TOMLValue",kind:"float",value:e.number,get number(){return l()},parent:n.parent,range:di(e.range),loc:fi(e.loc)},n.set(c)}processBooleanValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:"boolean",value:e.boolean,parent:n.parent,range:di(e.range),loc:fi(e.loc)};return n.set(s)}processDateTimeValue(e,t){let n=t.consumeValueContainer(),s={type:"TOMLValue",kind:XC[e.type],value:e.date,datetime:e.value,parent:n.parent,range:di(e.range),loc:fi(e.loc)};return n.set(s)}processArray(e,t){let n=t.consumeValueContainer(),s={type:"TOMLArray",elements:[],parent:n.parent,range:di(e.range),loc:fi(e.loc)},r=t.nextToken({valuesEnabled:!0});return Dl(r)?(ji(s,r),n.set(s)):(t.backToken(),this.processArrayValue(s,n,t))}processArrayValue(e,t,n){return n.addValueContainer({parent:e,set:s=>{e.elements.push(s);let r=n.nextToken({valuesEnabled:!0}),o=Yv(r);return o&&(r=n.nextToken({valuesEnabled:!0})),Dl(r)?(ji(e,r),t.set(e)):o?(n.backToken(),this.processArrayValue(e,t,n)):n.reportParseError(r?"missing-comma":"unterminated-array",r)}}),["VALUE"]}processInlineTable(e,t){let n=t.consumeValueContainer(),s={type:"TOMLInlineTable",body:[],parent:n.parent,range:di(e.range),loc:fi(e.loc)},r=this.tomlVersion.gte(1,1)?void 0:"invalid-inline-table-newline",o=t.nextToken({needSameLine:r});if(o){if(Ru(o)||Nl(o))return this.processInlineTableKeyValue(o,s,n,t);if(_m(o))return ji(s,o),n.set(s)}return t.reportParseError("unexpected-token",o)}processInlineTableKeyValue(e,t,n,s){let r={type:"TOMLKeyValue",key:null,value:null,parent:t,range:di(e.range),loc:fi(e.loc)};t.body.push(r);let{nextToken:o}=this.processKeyNode(e,r,s);if(!qv(o))return s.reportParseError("missing-equals-sign",o);let a=this.tomlVersion.gte(1,1)?void 0:"invalid-inline-table-newline";return s.addValueContainer({parent:r,set:l=>{r.value=l,ji(r,l);let c=s.nextToken({needSameLine:a});if(Yv(c)){if(c=s.nextToken({needSameLine:a}),c&&(Ru(c)||Nl(c)))return this.processInlineTableKeyValue(c,t,n,s);if(_m(c)){if(this.tomlVersion.lt(1,1))return s.reportParseError("invalid-trailing-comma-in-inline-table",c)}else return s.reportParseError(c?"unexpected-token":"unterminated-inline-table",c)}return _m(c)?(ji(t,c),n.set(t)):s.reportParseError(c?"missing-comma":"unterminated-inline-table",c)}}),s.needSameLine="invalid-key-value-newline",["VALUE"]}};Iu.TOMLParser=vm;function $C(i){return Yr(i)&&i.value==="."}function qv(i){return Yr(i)&&i.value==="="}function gm(i){return Yr(i)&&i.value==="["}function Dl(i){return Yr(i)&&i.value==="]"}function qC(i){return Yr(i)&&i.value==="{"}function _m(i){return Yr(i)&&i.value==="}"}function Yv(i){return Yr(i)&&i.value===","}function Yr(i){return!!(i&&i.type==="Punctuator")}function Ru(i){return i.type==="Bare"}function Nl(i){return i.type==="BasicString"||i.type==="LiteralString"}function Kv(i){return i.type==="MultiLineBasicString"||i.type==="MultiLineLiteralString"}function YC(i){return i.type==="Integer"||i.type==="Float"}function KC(i){return i.type==="Boolean"}function ZC(i){return i.type==="OffsetDateTime"||i.type==="LocalDateTime"||i.type==="LocalDate"||i.type==="LocalTime"}function ji(i,e){e&&(i.range[1]=e.range[1],i.loc.end=Lu(e.loc.end))}function di(i){return[i[0],i[1]]}function fi(i){return{start:Lu(i.start),end:Lu(i.end)}}function Lu(i){return{line:i.line,column:i.column}}});var Jv=Bn(Ul=>{"use strict";Object.defineProperty(Ul,"__esModule",{value:!0});var Ol={ArrayExpression:["elements"],ArrayPattern:["elements"],ArrowFunctionExpression:["params","body"],AssignmentExpression:["left","right"],AssignmentPattern:["left","right"],AwaitExpression:["argument"],BinaryExpression:["left","right"],BlockStatement:["body"],BreakStatement:["label"],CallExpression:["callee","arguments"],CatchClause:["param","body"],ChainExpression:["expression"],ClassBody:["body"],ClassDeclaration:["id","superClass","body"],ClassExpression:["id","superClass","body"],ConditionalExpression:["test","consequent","alternate"],ContinueStatement:["label"],DebuggerStatement:[],DoWhileStatement:["body","test"],EmptyStatement:[],ExperimentalRestProperty:["argument"],ExperimentalSpreadProperty:["argument"],ExportAllDeclaration:["exported","source"],ExportDefaultDeclaration:["declaration"],ExportNamedDeclaration:["declaration","specifiers","source"],ExportSpecifier:["exported","local"],ExpressionStatement:["expression"],ForInStatement:["left","right","body"],ForOfStatement:["left","right","body"],ForStatement:["init","test","update","body"],FunctionDeclaration:["id","params","body"],FunctionExpression:["id","params","body"],Identifier:[],IfStatement:["test","consequent","alternate"],ImportDeclaration:["specifiers","source"],ImportDefaultSpecifier:["local"],ImportExpression:["source"],ImportNamespaceSpecifier:["local"],ImportSpecifier:["imported","local"],JSXAttribute:["name","value"],JSXClosingElement:["name"],JSXClosingFragment:[],JSXElement:["openingElement","children","closingElement"],JSXEmptyExpression:[],JSXExpressionContainer:["expression"],JSXFragment:["openingFragment","children","closingFragment"],JSXIdentifier:[],JSXMemberExpression:["object","property"],JSXNamespacedName:["namespace","name"],JSXOpeningElement:["name","attributes"],JSXOpeningFragment:[],JSXSpreadAttribute:["argument"],JSXSpreadChild:["expression"],JSXText:[],LabeledStatement:["label","body"],Literal:[],LogicalExpression:["left","right"],MemberExpression:["object","property"],MetaProperty:["meta","property"],MethodDefinition:["key","value"],NewExpression:["callee","arguments"],ObjectExpression:["properties"],ObjectPattern:["properties"],PrivateIdentifier:[],Program:["body"],Property:["key","value"],PropertyDefinition:["key","value"],RestElement:["argument"],ReturnStatement:["argument"],SequenceExpression:["expressions"],SpreadElement:["argument"],StaticBlock:["body"],Super:[],SwitchCase:["test","consequent"],SwitchStatement:["discriminant","cases"],TaggedTemplateExpression:["tag","quasi"],TemplateElement:[],TemplateLiteral:["quasis","expressions"],ThisExpression:[],ThrowStatement:["argument"],TryStatement:["block","handler","finalizer"],UnaryExpression:["argument"],UpdateExpression:["argument"],VariableDeclaration:["declarations"],VariableDeclarator:["id","init"],WhileStatement:["test","body"],WithStatement:["object","body"],YieldExpression:["argument"]},JC=Object.keys(Ol);for(let i of JC)Object.freeze(Ol[i]);Object.freeze(Ol);var jC=new Set(["parent","leadingComments","trailingComments"]);function QC(i){return!jC.has(i)&&i[0]!=="_"}function eP(i){return Object.keys(i).filter(QC)}function tP(i){let e=Object.assign({},Ol);for(let t of Object.keys(i))if(Object.prototype.hasOwnProperty.call(e,t)){let n=new Set(i[t]);for(let s of e[t])n.add(s);e[t]=Object.freeze(Array.from(n))}else e[t]=Object.freeze(Array.from(i[t]));return Object.freeze(e)}Ul.KEYS=Ol;Ul.getKeys=eP;Ul.unionWith=tP});var Du=Bn(ku=>{"use strict";Object.defineProperty(ku,"__esModule",{value:!0});ku.KEYS=void 0;var nP=Jv(),iP={Program:["body"],TOMLTopLevelTable:["body"],TOMLTable:["key","body"],TOMLKeyValue:["key","value"],TOMLKey:["keys"],TOMLArray:["elements"],TOMLInlineTable:["body"],TOMLBare:[],TOMLQuoted:[],TOMLValue:[]};ku.KEYS=(0,nP.unionWith)(iP)});var jv=Bn(Nu=>{"use strict";Object.defineProperty(Nu,"__esModule",{value:!0});Nu.parseForESLint=void 0;var sP=Zv(),rP=Du();function oP(i,e){return{ast:new sP.TOMLParser(i,e).parse(),visitorKeys:rP.KEYS,services:{isTOML:!0}}}Nu.parseForESLint=oP});var iy=Bn(Ss=>{"use strict";Object.defineProperty(Ss,"__esModule",{value:!0});Ss.traverseNodes=Ss.getNodes=Ss.getKeys=Ss.getFallbackKeys=void 0;var aP=Du();function lP(i){let e=null;return i!=="comments"&&i!=="leadingComments"&&i!=="loc"&&i!=="parent"&&i!=="range"&&i!=="tokens"&&i!=="trailingComments"&&(e=this[i])!==null&&typeof e=="object"&&(typeof e.type=="string"||Array.isArray(e))}function ey(i){return Object.keys(i).filter(lP,i)}Ss.getFallbackKeys=ey;function ty(i,e){return((e||aP.KEYS)[i.type]||ey(i)).filter(n=>!ym(i,n).next().done)}Ss.getKeys=ty;function*ym(i,e){let t=i[e];if(Array.isArray(t))for(let n of t)Qv(n)&&(yield n);else Qv(t)&&(yield t)}Ss.getNodes=ym;function Qv(i){return i!==null&&typeof i=="object"&&typeof i.type=="string"}function ny(i,e,t){t.enterNode(i,e);let n=ty(i,t.visitorKeys);for(let s of n)for(let r of ym(i,s))ny(r,i,t);t.leaveNode(i,e)}function cP(i,e){ny(i,null,e)}Ss.traverseNodes=cP});var oy=Bn(oa=>{"use strict";Object.defineProperty(oa,"__esModule",{value:!0});oa.generateConvertTOMLValue=oa.getStaticTOMLValue=void 0;var sy=gu();oa.getStaticTOMLValue=ry(i=>i.value);function ry(i){function e(n,s){return t[n.type](n,s)}let t={Program(n,s={}){return e(n.body[0],s)},TOMLTopLevelTable(n,s={}){for(let r of n.body)e(r,s);return s},TOMLKeyValue(n,s={}){let r=e(n.value);return uP(s,e(n.key),r),s},TOMLTable(n,s={}){let r=hP(s,e(n.key),n.kind==="array");for(let o of n.body)e(o,r);return s},TOMLArray(n){return n.elements.map(s=>e(s))},TOMLInlineTable(n){let s={};for(let r of n.body)e(r,s);return s},TOMLKey(n){return n.keys.map(s=>e(s))},TOMLBare(n){return n.name},TOMLQuoted(n){return n.value},TOMLValue(n){return i(n)}};return n=>e(n)}oa.generateConvertTOMLValue=ry;function hP(i,e,t){let n=i;for(let l=0;l<e.length-1;l++){let c=e[l];n=a(n,c)}let s=(0,sy.last)(e),r=n[s];if(r==null){let l={};return n[s]=t?[l]:l,l}if(Ou(r)){let l={};return n[s]=t?[l]:l,l}if(!t){if(Array.isArray(r)){let l={};return n[s]=l,l}return r}if(Array.isArray(r)){let l={};return r.push(l),l}let o={};return n[s]=[o],o;function a(l,c){let h=l[c];if(h==null){let d={};return l[c]=d,d}if(Ou(h)){let d={};return l[c]=d,d}let u=h;for(;Array.isArray(u);){let d=u.length-1,f=u[d];if(Ou(f)){let g={};return u[d]=g,g}u=f}return u}}function uP(i,e,t){let n=i;for(let s=0;s<e.length-1;s++){let r=e[s],o=n[r];if(o==null){let a={};n[r]=a,n=a}else if(Ou(o)||Array.isArray(o)){let a={};n[r]=a,n=a}else n=o}n[(0,sy.last)(e)]=t}function Ou(i){return typeof i!="object"||i instanceof Date}});var xm=Bn(aa=>{"use strict";Object.defineProperty(aa,"__esModule",{value:!0});aa.version=aa.name=void 0;aa.name="toml-eslint-parser";aa.version="0.10.0"});var ly=Bn(Qt=>{"use strict";var dP=Qt&&Qt.__createBinding||(Object.create?(function(i,e,t,n){n===void 0&&(n=t);var s=Object.getOwnPropertyDescriptor(e,t);(!s||("get"in s?!e.__esModule:s.writable||s.configurable))&&(s={enumerable:!0,get:function(){return e[t]}}),Object.defineProperty(i,n,s)}):(function(i,e,t,n){n===void 0&&(n=t),i[n]=e[t]})),fP=Qt&&Qt.__setModuleDefault||(Object.create?(function(i,e){Object.defineProperty(i,"default",{enumerable:!0,value:e})}):function(i,e){i.default=e}),pP=Qt&&Qt.__importStar||function(i){if(i&&i.__esModule)return i;var e={};if(i!=null)for(var t in i)t!=="default"&&Object.prototype.hasOwnProperty.call(i,t)&&dP(e,i,t);return fP(e,i),e};Object.defineProperty(Qt,"__esModule",{value:!0});Qt.parseTOML=Qt.getStaticTOMLValue=Qt.traverseNodes=Qt.VisitorKeys=Qt.parseForESLint=Qt.ParseError=Qt.name=Qt.meta=void 0;var ay=jv();Object.defineProperty(Qt,"parseForESLint",{enumerable:!0,get:function(){return ay.parseForESLint}});var mP=iy();Object.defineProperty(Qt,"traverseNodes",{enumerable:!0,get:function(){return mP.traverseNodes}});var gP=oy();Object.defineProperty(Qt,"getStaticTOMLValue",{enumerable:!0,get:function(){return gP.getStaticTOMLValue}});var _P=Du(),vP=bu();Object.defineProperty(Qt,"ParseError",{enumerable:!0,get:function(){return vP.ParseError}});Qt.meta=pP(xm());var yP=xm();Object.defineProperty(Qt,"name",{enumerable:!0,get:function(){return yP.name}});Qt.VisitorKeys=_P.KEYS;function xP(i,e){return(0,ay.parseForESLint)(i,e).ast}Qt.parseTOML=xP});function x(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))n.setAttribute(s,r);return n.append(...t),n}function Ce(i,e){i.textContent!==e&&(i.textContent=e)}function dt(i,e,t){i.classList.contains(e)!==t&&i.classList.toggle(e,t)}function $e(i,e,t){i.getAttribute(e)!==t&&i.setAttribute(e,t)}function hc(i,e,t){let n=i.textContent;i.addEventListener("click",()=>{i.textContent===n?Ce(i,e):t()}),i.addEventListener("blur",()=>{Ce(i,n)})}function li(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 16 16"),e.setAttribute("aria-hidden","true"),e.classList.add("icon");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",yS[i]),e.append(t),e}var yS={play:"M4 2.5v11l9-5.5z",pause:"M4 3h3v10H4zM9 3h3v10H9z",record:"M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z",wheel:"M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 0 1 4.3 3.2L9.6 7a1.8 1.8 0 0 0-3.2 0l-2.7-.3A4.5 4.5 0 0 1 8 3.5zM7 12.4A4.5 4.5 0 0 1 3.6 8.7l2.6.4.8 1zm2 0v-2.3l.8-1 2.6-.4A4.5 4.5 0 0 1 9 12.4z",theme:"M8 1.5a6.5 6.5 0 1 0 0 13a6.5 6.5 0 1 0 0-13zM8 3.2v9.6a4.8 4.8 0 0 1 0-9.6z",grid:"M2 2h5v5H2zM9 2h5v5H9zM2 9h5v5H2zM9 9h5v5H9z",square:"M4 4h8v8H4z",close:"M4 5l1-1 3 3 3-3 1 1-3 3 3 3-1 1-3-3-3 3-1-1 3-3z",stop:"M5.3 1.5h5.4l3.8 3.8v5.4l-3.8 3.8H5.3l-3.8-3.8V5.3z"};var gr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},_r={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Q0=0,hp=1,e_=2;var Br=1,t_=2,Yo=3,vr=0,ri=1,hi=2,zr=0,Ko=1,up=2,dp=3,fp=4,n_=5;var Vr=100,i_=101,s_=102,r_=103,o_=104,a_=200,l_=201,c_=202,h_=203,pp=204,mp=205,u_=206,d_=207,f_=208,p_=209,m_=210,g_=211,__=212,v_=213,y_=214,Bc=0,zc=1,Vc=2,zo=3,Hc=4,Gc=5,Wc=6,Xc=7,_h=0,x_=1,b_=2,xs=0,gp=1,_p=2,vp=3,yp=4,xp=5,bp=6,wp=7;var Sp=300,Hr=301,Zo=302,vh=303,yh=304,$c=1e3,ms=1001,qc=1002,xn=1003,w_=1004;var _l=1005;var ii=1006,xh=1007;var $s=1008;var ui=1009,Mp=1010,Tp=1011,Jo=1012,bh=1013,Ki=1014,Ni=1015,Zi=1016,wh=1017,Sh=1018,Gr=1020,Ep=35902,Ap=35899,Cp=1021,Pp=1022,Ji=1023,Vs=1026,qs=1027,Mh=1028,Th=1029,yr=1030,Eh=1031;var Ah=1033,vl=33776,yl=33777,xl=33778,bl=33779,Ch=35840,Ph=35841,Rh=35842,Lh=35843,Ih=36196,kh=37492,Dh=37496,Nh=37488,Oh=37489,wl=37490,Uh=37491,Fh=37808,Bh=37809,zh=37810,Vh=37811,Hh=37812,Gh=37813,Wh=37814,Xh=37815,$h=37816,qh=37817,Yh=37818,Kh=37819,Zh=37820,Jh=37821,jh=36492,Qh=36494,eu=36495,tu=36283,nu=36284,Sl=36285,iu=36286;var Ya=2300,Yc=2301,Uc=2302,ip=2303,sp=2400,rp=2401,op=2402;var S_=3200;var su=0,M_=1,Ys="",ti="srgb",Ka="srgb-linear",Za="linear",Rt="srgb";var Fc=7680;var T_=519,E_=512,A_=513,C_=514,Rp=515,P_=516,R_=517,Lp=518,Ip=519,L_=35044;var kp="300 es",ki=2e3,Vo=2001;function xS(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function bS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ja(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function I_(){let i=Ja("canvas");return i.style.display="block",i}var S0={},Ho=null;function Dp(...i){let e="THREE."+i.shift();Ho?Ho("log",e,...i):console.log(e,...i)}function k_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=k_(i);let e="THREE."+i.shift();if(Ho)Ho("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function it(...i){i=k_(i);let e="THREE."+i.shift();if(Ho)Ho("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function $a(...i){let e=i.join(" ");e in S0||(S0[e]=!0,Ke(...i))}function D_(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var N_={[Bc]:Bc,[Vc]:Wc,[Hc]:Hc,[zo]:Gc,[zc]:zc,[Wc]:Vc,[Xc]:Xc,[Gc]:zo},qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],M0=1234567,Fo=Math.PI/180,Go=180/Math.PI;function jo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function Np(i,e){return(i%e+e)%e}function wS(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function SS(i,e,t){return i!==e?(t-i)/(e-i):0}function qa(i,e,t){return(1-t)*i+t*e}function MS(i,e,t,n){return qa(i,e,1-Math.exp(-t*n))}function TS(i,e=1){return e-Math.abs(Np(i,e*2)-e)}function ES(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function AS(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function CS(i,e){return i+Math.floor(Math.random()*(e-i+1))}function PS(i,e){return i+Math.random()*(e-i)}function RS(i){return i*(.5-Math.random())}function LS(i){i!==void 0&&(M0=i);let e=M0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function IS(i){return i*Fo}function kS(i){return i*Go}function DS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function NS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Op(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function OS(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Up(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function O_(i,e){if(e.constructor===Float32Array)return i;let t=Up(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function U_(i,e){if(e.constructor===Float32Array)return i;let t=Up(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Fp={DEG2RAD:Fo,RAD2DEG:Go,generateUUID:jo,clamp:yt,euclideanModulo:Np,mapLinear:wS,inverseLerp:SS,lerp:qa,damp:MS,pingpong:TS,smoothstep:ES,smootherstep:AS,randInt:CS,randFloat:PS,randFloatSpread:RS,seededRandom:LS,degToRad:IS,radToDeg:kS,isPowerOfTwo:DS,ceilPowerOfTwo:NS,floorPowerOfTwo:Op,setQuaternionFromProperEuler:OS,normalize:U_,denormalize:O_},Gp=class Gp{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Gp.prototype.isVector2=!0;var tt=Gp,si=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let b=Math.acos(p),C=Math.sin(b);m=Math.sin(m*b)/C,a=Math.sin(a*b)/C,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a;let b=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=b,c*=b,h*=b,u*=b}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Wp=class Wp{constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(T0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(T0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Nf.copy(this).projectOnVector(e),this.sub(Nf)}reflect(e){return this.sub(Nf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Wp.prototype.isVector3=!0;var q=Wp,Nf=new q,T0=new si,Xp=class Xp{constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],y=s[0],p=s[3],m=s[6],b=s[1],C=s[4],T=s[7],R=s[2],E=s[5],v=s[8];return r[0]=o*y+a*b+l*R,r[3]=o*p+a*C+l*E,r[6]=o*m+a*T+l*v,r[1]=c*y+h*b+u*R,r[4]=c*p+h*C+u*E,r[7]=c*m+h*T+u*v,r[2]=d*y+f*b+g*R,r[5]=d*p+f*C+g*E,r[8]=d*m+f*T+g*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return $a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Of.makeScale(e,t)),this}rotate(e){return $a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Of.makeRotation(-e)),this}translate(e,t){return $a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Of.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}};Xp.prototype.isMatrix3=!0;var st=Xp,Of=new st,E0=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),A0=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function US(){let i={enabled:!0,workingColorSpace:Ka,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Rt&&(s.r=zs(s.r),s.g=zs(s.g),s.b=zs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Rt&&(s.r=Bo(s.r),s.g=Bo(s.g),s.b=Bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ys?Za:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ka]:{primaries:e,whitePoint:n,transfer:Za,toXYZ:E0,fromXYZ:A0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ti},outputColorSpaceConfig:{drawingBufferColorSpace:ti}},[ti]:{primaries:e,whitePoint:n,transfer:Rt,toXYZ:E0,fromXYZ:A0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ti}}}),i}var wt=US();function zs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Bo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Mo,Kc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Mo===void 0&&(Mo=Ja("canvas")),Mo.width=e.width,Mo.height=e.height;let s=Mo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Mo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ja("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=zs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(zs(t[n]/255)*255):t[n]=zs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},FS=0,Wo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:FS++}),this.uuid=jo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Uf(s[o].image)):r.push(Uf(s[o]))}else r=Uf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Uf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Kc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var BS=0,Ff=new q,ci=class i extends qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ms,s=ms,r=ii,o=$s,a=Ji,l=ui,c=i.DEFAULT_ANISOTROPY,h=Ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:BS++}),this.uuid=jo(),this.name="",this.source=new Wo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ff).x}get height(){return this.source.getSize(Ff).y}get depth(){return this.source.getSize(Ff).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Sp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case $c:e.x=e.x-Math.floor(e.x);break;case ms:e.x=e.x<0?0:1;break;case qc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case $c:e.y=e.y-Math.floor(e.y);break;case ms:e.y=e.y<0?0:1;break;case qc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ci.DEFAULT_IMAGE=null;ci.DEFAULT_MAPPING=Sp;ci.DEFAULT_ANISOTROPY=1;var $p=class $p{constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,T=(f+1)/2,R=(m+1)/2,E=(h+d)/4,v=(u+y)/4,A=(g+p)/4;return C>T&&C>R?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=E/n,r=v/n):T>R?T<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(T),n=E/s,r=A/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=v/r,s=A/r),this.set(n,s,r,t),this}let b=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(b)<.001&&(b=1),this.x=(p-g)/b,this.y=(u-y)/b,this.z=(d-h)/b,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};$p.prototype.isVector4=!0;var jt=$p,Zc=class extends qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ii,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new jt(0,0,e,t),this.scissorTest=!1,this.viewport=new jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ci({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Wo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends Zc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ja=class extends ci{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=xn,this.minFilter=xn,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jc=class extends ci{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=xn,this.minFilter=xn,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var gh=class gh{constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new gh().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/To.setFromMatrixColumn(e,0).length(),r=1/To.setFromMatrixColumn(e,1).length(),o=1/To.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(zS,e,VS)}lookAt(e,t,n){let s=this.elements;return yi.subVectors(e,t),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),rr.crossVectors(n,yi),rr.lengthSq()===0&&(Math.abs(n.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),rr.crossVectors(n,yi)),rr.normalize(),uc.crossVectors(yi,rr),s[0]=rr.x,s[4]=uc.x,s[8]=yi.x,s[1]=rr.y,s[5]=uc.y,s[9]=yi.y,s[2]=rr.z,s[6]=uc.z,s[10]=yi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],y=n[6],p=n[10],m=n[14],b=n[3],C=n[7],T=n[11],R=n[15],E=s[0],v=s[4],A=s[8],z=s[12],N=s[1],D=s[5],W=s[9],G=s[13],I=s[2],F=s[6],$=s[10],V=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*E+a*N+l*I+c*le,r[4]=o*v+a*D+l*F+c*Z,r[8]=o*A+a*W+l*$+c*Q,r[12]=o*z+a*G+l*V+c*ie,r[1]=h*E+u*N+d*I+f*le,r[5]=h*v+u*D+d*F+f*Z,r[9]=h*A+u*W+d*$+f*Q,r[13]=h*z+u*G+d*V+f*ie,r[2]=g*E+y*N+p*I+m*le,r[6]=g*v+y*D+p*F+m*Z,r[10]=g*A+y*W+p*$+m*Q,r[14]=g*z+y*G+p*V+m*ie,r[3]=b*E+C*N+T*I+R*le,r[7]=b*v+C*D+T*F+R*Z,r[11]=b*A+C*W+T*$+R*Q,r[15]=b*z+C*G+T*V+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],b=l*f-c*d,C=a*f-c*u,T=a*d-l*u,R=o*f-c*h,E=o*d-l*h,v=o*u-a*h;return t*(y*b-p*C+m*T)-n*(g*b-p*R+m*E)+s*(g*C-y*R+m*v)-r*(g*T-y*E+p*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],b=t*a-n*o,C=t*l-s*o,T=t*c-r*o,R=n*l-s*a,E=n*c-r*a,v=s*c-r*l,A=h*y-u*g,z=h*p-d*g,N=h*m-f*g,D=u*p-d*y,W=u*m-f*y,G=d*m-f*p,I=b*G-C*W+T*D+R*N-E*z+v*A;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let F=1/I;return e[0]=(a*G-l*W+c*D)*F,e[1]=(s*W-n*G-r*D)*F,e[2]=(y*v-p*E+m*R)*F,e[3]=(d*E-u*v-f*R)*F,e[4]=(l*N-o*G-c*z)*F,e[5]=(t*G-s*N+r*z)*F,e[6]=(p*T-g*v-m*C)*F,e[7]=(h*v-d*T+f*C)*F,e[8]=(o*W-a*N+c*A)*F,e[9]=(n*N-t*W-r*A)*F,e[10]=(g*E-y*T+m*b)*F,e[11]=(u*T-h*E-f*b)*F,e[12]=(a*z-o*D-l*A)*F,e[13]=(t*D-n*z+s*A)*F,e[14]=(y*C-g*R-p*b)*F,e[15]=(h*R-u*C+d*b)*F,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,y=o*h,p=o*u,m=a*u,b=l*c,C=l*h,T=l*u,R=n.x,E=n.y,v=n.z;return s[0]=(1-(y+m))*R,s[1]=(f+T)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(f-T)*E,s[5]=(1-(d+m))*E,s[6]=(p+b)*E,s[7]=0,s[8]=(g+C)*v,s[9]=(p-b)*v,s[10]=(1-(d+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=To.set(s[0],s[1],s[2]).length(),a=To.set(s[4],s[5],s[6]).length(),l=To.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Wi.copy(this);let c=1/o,h=1/a,u=1/l;return Wi.elements[0]*=c,Wi.elements[1]*=c,Wi.elements[2]*=c,Wi.elements[4]*=h,Wi.elements[5]*=h,Wi.elements[6]*=h,Wi.elements[8]*=u,Wi.elements[9]*=u,Wi.elements[10]*=u,t.setFromRotationMatrix(Wi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=ki,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===ki)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Vo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=ki,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===ki)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Vo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}};gh.prototype.isMatrix4=!0;var Lt=gh,To=new q,Wi=new Lt,zS=new q(0,0,0),VS=new q(1,1,1),rr=new q,uc=new q,yi=new q,C0=new Lt,P0=new si,Hs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return C0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(C0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return P0.setFromEuler(this),this.setFromQuaternion(P0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Hs.DEFAULT_ORDER="XYZ";var Qa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},HS=0,R0=new q,Eo=new si,Ds=new Lt,dc=new q,Ba=new q,GS=new q,WS=new si,L0=new q(1,0,0),I0=new q(0,1,0),k0=new q(0,0,1),D0={type:"added"},XS={type:"removed"},Ao={type:"childadded",child:null},Bf={type:"childremoved",child:null},Xn=class i extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:HS++}),this.uuid=jo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new q,t=new Hs,n=new si,s=new q(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Lt},normalMatrix:{value:new st}}),this.matrix=new Lt,this.matrixWorld=new Lt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Eo.setFromAxisAngle(e,t),this.quaternion.multiply(Eo),this}rotateOnWorldAxis(e,t){return Eo.setFromAxisAngle(e,t),this.quaternion.premultiply(Eo),this}rotateX(e){return this.rotateOnAxis(L0,e)}rotateY(e){return this.rotateOnAxis(I0,e)}rotateZ(e){return this.rotateOnAxis(k0,e)}translateOnAxis(e,t){return R0.copy(e).applyQuaternion(this.quaternion),this.position.add(R0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(L0,e)}translateY(e){return this.translateOnAxis(I0,e)}translateZ(e){return this.translateOnAxis(k0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ds.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?dc.copy(e):dc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ba.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ds.lookAt(Ba,dc,this.up):Ds.lookAt(dc,Ba,this.up),this.quaternion.setFromRotationMatrix(Ds),s&&(Ds.extractRotation(s.matrixWorld),Eo.setFromRotationMatrix(Ds),this.quaternion.premultiply(Eo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(D0),Ao.child=e,this.dispatchEvent(Ao),Ao.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(XS),Bf.child=e,this.dispatchEvent(Bf),Bf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(D0),Ao.child=e,this.dispatchEvent(Ao),Ao.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ba,e,GS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ba,WS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Xn.DEFAULT_UP=new q(0,1,0);Xn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Di=class extends Xn{constructor(){super(),this.isGroup=!0,this.type="Group"}},$S={type:"move"},Xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Di,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Di,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Di,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent($S)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Di;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},F_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},or={h:0,s:0,l:0},fc={h:0,s:0,l:0};function zf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ft=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ti){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,wt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=wt.workingColorSpace){return this.r=e,this.g=t,this.b=n,wt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=wt.workingColorSpace){if(e=Np(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=zf(o,r,e+1/3),this.g=zf(o,r,e),this.b=zf(o,r,e-1/3)}return wt.colorSpaceToWorking(this,s),this}setStyle(e,t=ti){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ti){let n=F_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=zs(e.r),this.g=zs(e.g),this.b=zs(e.b),this}copyLinearToSRGB(e){return this.r=Bo(e.r),this.g=Bo(e.g),this.b=Bo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ti){return wt.workingToColorSpace(Yn.copy(this),e),Math.round(yt(Yn.r*255,0,255))*65536+Math.round(yt(Yn.g*255,0,255))*256+Math.round(yt(Yn.b*255,0,255))}getHexString(e=ti){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=wt.workingColorSpace){wt.workingToColorSpace(Yn.copy(this),t);let n=Yn.r,s=Yn.g,r=Yn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=wt.workingColorSpace){return wt.workingToColorSpace(Yn.copy(this),t),e.r=Yn.r,e.g=Yn.g,e.b=Yn.b,e}getStyle(e=ti){wt.workingToColorSpace(Yn.copy(this),e);let t=Yn.r,n=Yn.g,s=Yn.b;return e!==ti?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(or),this.setHSL(or.h+e,or.s+t,or.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(or),e.getHSL(fc);let n=qa(or.h,fc.h,t),s=qa(or.s,fc.s,t),r=qa(or.l,fc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Yn=new ft;ft.NAMES=F_;var el=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ft(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},tl=class extends Xn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Hs,this.environmentIntensity=1,this.environmentRotation=new Hs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Xi=new q,Ns=new q,Vf=new q,Os=new q,Co=new q,Po=new q,N0=new q,Hf=new q,Gf=new q,Wf=new q,Xf=new jt,$f=new jt,qf=new jt,Bs=class i{constructor(e=new q,t=new q,n=new q){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Xi.subVectors(e,t),s.cross(Xi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Xi.subVectors(s,t),Ns.subVectors(n,t),Vf.subVectors(e,t);let o=Xi.dot(Xi),a=Xi.dot(Ns),l=Xi.dot(Vf),c=Ns.dot(Ns),h=Ns.dot(Vf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Os)===null?!1:Os.x>=0&&Os.y>=0&&Os.x+Os.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Os.x),l.addScaledVector(o,Os.y),l.addScaledVector(a,Os.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Xf.setScalar(0),$f.setScalar(0),qf.setScalar(0),Xf.fromBufferAttribute(e,t),$f.fromBufferAttribute(e,n),qf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Xf,r.x),o.addScaledVector($f,r.y),o.addScaledVector(qf,r.z),o}static isFrontFacing(e,t,n,s){return Xi.subVectors(n,t),Ns.subVectors(e,t),Xi.cross(Ns).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xi.subVectors(this.c,this.b),Ns.subVectors(this.a,this.b),Xi.cross(Ns).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Co.subVectors(s,n),Po.subVectors(r,n),Hf.subVectors(e,n);let l=Co.dot(Hf),c=Po.dot(Hf);if(l<=0&&c<=0)return t.copy(n);Gf.subVectors(e,s);let h=Co.dot(Gf),u=Po.dot(Gf);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Co,o);Wf.subVectors(e,r);let f=Co.dot(Wf),g=Po.dot(Wf);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Po,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return N0.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(N0,a);let m=1/(p+y+d);return o=y*m,a=d*m,t.copy(n).addScaledVector(Co,o).addScaledVector(Po,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},gs=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$i):$i.fromBufferAttribute(r,o),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),pc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),pc.copy(n.boundingBox)),pc.applyMatrix4(e.matrixWorld),this.union(pc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(za),mc.subVectors(this.max,za),Ro.subVectors(e.a,za),Lo.subVectors(e.b,za),Io.subVectors(e.c,za),ar.subVectors(Lo,Ro),lr.subVectors(Io,Lo),Rr.subVectors(Ro,Io);let t=[0,-ar.z,ar.y,0,-lr.z,lr.y,0,-Rr.z,Rr.y,ar.z,0,-ar.x,lr.z,0,-lr.x,Rr.z,0,-Rr.x,-ar.y,ar.x,0,-lr.y,lr.x,0,-Rr.y,Rr.x,0];return!Yf(t,Ro,Lo,Io,mc)||(t=[1,0,0,0,1,0,0,0,1],!Yf(t,Ro,Lo,Io,mc))?!1:(gc.crossVectors(ar,lr),t=[gc.x,gc.y,gc.z],Yf(t,Ro,Lo,Io,mc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Us=[new q,new q,new q,new q,new q,new q,new q,new q],$i=new q,pc=new gs,Ro=new q,Lo=new q,Io=new q,ar=new q,lr=new q,Rr=new q,za=new q,mc=new q,gc=new q,Lr=new q;function Yf(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Lr.fromArray(i,r);let a=s.x*Math.abs(Lr.x)+s.y*Math.abs(Lr.y)+s.z*Math.abs(Lr.z),l=e.dot(Lr),c=t.dot(Lr),h=n.dot(Lr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var yn=new q,_c=new tt,qS=0,Vn=class extends qi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:qS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=L_,this.updateRanges=[],this.gpuType=Ni,this.version=0,this._normalizationScale=e!==void 0?Up(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)_c.fromBufferAttribute(this,t),_c.applyMatrix3(e),this.setXY(t,_c.x,_c.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):O_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):U_(e,this.array)}};var nl=class extends Vn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var il=class extends Vn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Hn=class extends Vn{constructor(e,t,n){super(new Float32Array(e),t,n)}},YS=new gs,Va=new q,Kf=new q,Gs=class{constructor(e=new q,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):YS.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Va.subVectors(e,this.center);let t=Va.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Va,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Kf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Va.copy(e.center).add(Kf)),this.expandByPoint(Va.copy(e.center).sub(Kf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},KS=0,Ii=new Lt,Zf=new Xn,ko=new q,xi=new gs,Ha=new gs,zn=new q,An=class i extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:KS++}),this.uuid=jo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(xS(e)?il:nl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new st().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ii.makeRotationFromQuaternion(e),this.applyMatrix4(Ii),this}rotateX(e){return Ii.makeRotationX(e),this.applyMatrix4(Ii),this}rotateY(e){return Ii.makeRotationY(e),this.applyMatrix4(Ii),this}rotateZ(e){return Ii.makeRotationZ(e),this.applyMatrix4(Ii),this}translate(e,t,n){return Ii.makeTranslation(e,t,n),this.applyMatrix4(Ii),this}scale(e,t,n){return Ii.makeScale(e,t,n),this.applyMatrix4(Ii),this}lookAt(e){return Zf.lookAt(e),Zf.updateMatrix(),this.applyMatrix4(Zf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ko).negate(),this.translate(ko.x,ko.y,ko.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Hn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];xi.setFromBufferAttribute(r),this.morphTargetsRelative?(zn.addVectors(this.boundingBox.min,xi.min),this.boundingBox.expandByPoint(zn),zn.addVectors(this.boundingBox.max,xi.max),this.boundingBox.expandByPoint(zn)):(this.boundingBox.expandByPoint(xi.min),this.boundingBox.expandByPoint(xi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let n=this.boundingSphere.center;if(xi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ha.setFromBufferAttribute(a),this.morphTargetsRelative?(zn.addVectors(xi.min,Ha.min),xi.expandByPoint(zn),zn.addVectors(xi.max,Ha.max),xi.expandByPoint(zn)):(xi.expandByPoint(Ha.min),xi.expandByPoint(Ha.max))}xi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)zn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(zn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)zn.fromBufferAttribute(a,c),l&&(ko.fromBufferAttribute(e,c),zn.add(ko)),s=Math.max(s,n.distanceToSquared(zn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Vn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)a[z]=new q,l[z]=new q;let h=new q,u=new q,d=new q,f=new tt,g=new tt,y=new tt,p=new q,m=new q;function b(z,N,D){c[z]=c[N]=c[D]=1,h.fromBufferAttribute(n,z),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,z),g.fromBufferAttribute(r,N),y.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(f),y.sub(f);let W=1/(g.x*y.y-y.x*g.y);isFinite(W)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(W),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(W),a[z].add(p),a[N].add(p),a[D].add(p),l[z].add(m),l[N].add(m),l[D].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let z=0,N=C.length;z<N;++z){let D=C[z],W=D.start,G=D.count;for(let I=W,F=W+G;I<F;I+=3)b(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let T=new q,R=new q,E=new q,v=new q;function A(z){E.fromBufferAttribute(s,z),v.copy(E);let N=a[z];T.copy(N),T.sub(E.multiplyScalar(E.dot(N))).normalize(),R.crossVectors(v,N);let W=R.dot(l[z])<0?-1:1;o.setXYZW(z,T.x,T.y,T.z,W)}for(let z=0,N=n.count;z<N;++z)c[z]&&A(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Vn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,h=new q,u=new q;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)zn.fromBufferAttribute(e,t),zn.normalize(),e.setXYZ(t,zn.x,zn.y,zn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new Vn(d,h,u)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Jf=new q,ZS=new q,JS=new st,bi=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Jf.subVectors(n,t).cross(ZS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Jf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||JS.getNormalMatrix(e),s=this.coplanarPoint(Jf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},jS=0,Ws=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:jS++}),this.uuid=jo(),this.name="",this.type="Material",this.blending=Ko,this.side=vr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=pp,this.blendDst=mp,this.blendEquation=Vr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ft(0,0,0),this.blendAlpha=0,this.depthFunc=zo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=T_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Fc,this.stencilZFail=Fc,this.stencilZPass=Fc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ft().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new bi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new tt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Fs=new q,jf=new q,vc=new q,yc=new q,Dr=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Fs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Fs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Fs.copy(this.origin).addScaledVector(this.direction,t),Fs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){jf.copy(e).add(t).multiplyScalar(.5),vc.copy(t).sub(e).normalize(),yc.copy(this.origin).sub(jf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(vc),a=yc.dot(this.direction),l=-yc.dot(vc),c=yc.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(jf).addScaledVector(vc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Fs.subVectors(e.center,this.origin);let n=Fs.dot(this.direction),s=Fs.dot(Fs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Fs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=n.x-o.x,b=n.y-o.y,C=n.z-o.z,T=Math.abs(l),R=Math.abs(c),E=Math.abs(h),v,A,z,N,D,W,G,I,F,$,V,le;if(T>=R&&T>=E?(z=l,W=u,F=g,le=m,l>=0?(v=c,A=h,N=d,D=f,G=y,I=p,$=b,V=C):(v=h,A=c,N=f,D=d,G=p,I=y,$=C,V=b)):R>=E?(z=c,W=d,F=y,le=b,c>=0?(v=h,A=l,N=f,D=u,G=p,I=g,$=C,V=m):(v=l,A=h,N=u,D=f,G=g,I=p,$=m,V=C)):(z=h,W=f,F=p,le=C,h>=0?(v=l,A=c,N=u,D=d,G=g,I=y,$=m,V=b):(v=c,A=l,N=d,D=u,G=y,I=g,$=b,V=m)),z===0)return null;let Z=v/z,Q=A/z,ie=1/z,de=N-Z*W,ue=D-Q*W,ee=G-Z*F,me=I-Q*F,ge=$-Z*le,ve=V-Q*le,_e=ge*me-ve*ee,Ge=de*ve-ue*ge,Je=ee*ue-me*de;if(s){if(_e<0||Ge<0||Je<0)return null}else if((_e<0||Ge<0||Je<0)&&(_e>0||Ge>0||Je>0))return null;let Ue=_e+Ge+Je;if(Ue===0)return null;let ot=ie*(_e*W+Ge*F+Je*le);return(Ue>0?ot<0:ot>0)?null:this.at(ot/Ue,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hr=class extends Ws{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Hs,this.combine=_h,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},O0=new Lt,Ir=new Dr,xc=new Gs,U0=new q,bc=new q,wc=new q,Sc=new q,Qf=new q,Mc=new q,F0=new q,Tc=new q,nn=class extends Xn{constructor(e=new An,t=new hr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Mc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Qf.fromBufferAttribute(u,e),o?Mc.addScaledVector(Qf,h):Mc.addScaledVector(Qf.sub(t),h))}t.add(Mc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),xc.copy(n.boundingSphere),xc.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(xc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(xc,U0)===null||Ir.origin.distanceToSquared(U0)>(e.far-e.near)**2))&&(O0.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(O0),!(n.boundingBox!==null&&Ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],b=Math.max(p.start,f.start),C=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let T=b,R=C;T<R;T+=3){let E=a.getX(T),v=a.getX(T+1),A=a.getX(T+2);s=Ec(this,m,e,n,c,h,u,E,v,A),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let b=a.getX(p),C=a.getX(p+1),T=a.getX(p+2);s=Ec(this,o,e,n,c,h,u,b,C,T),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],b=Math.max(p.start,f.start),C=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let T=b,R=C;T<R;T+=3){let E=T,v=T+1,A=T+2;s=Ec(this,m,e,n,c,h,u,E,v,A),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let b=p,C=p+1,T=p+2;s=Ec(this,o,e,n,c,h,u,b,C,T),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function QS(i,e,t,n,s,r,o,a){let l;if(e.side===ri?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===vr,a),l===null)return null;Tc.copy(a),Tc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Tc);return c<t.near||c>t.far?null:{distance:c,point:Tc.clone(),object:i}}function Ec(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,bc),i.getVertexPosition(l,wc),i.getVertexPosition(c,Sc);let h=QS(i,e,t,n,bc,wc,Sc,F0);if(h){let u=new q;Bs.getBarycoord(F0,bc,wc,Sc,u),s&&(h.uv=Bs.getInterpolatedAttribute(s,a,l,c,u,new tt)),r&&(h.uv1=Bs.getInterpolatedAttribute(r,a,l,c,u,new tt)),o&&(h.normal=Bs.getInterpolatedAttribute(o,a,l,c,u,new q),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new q,materialIndex:0};Bs.getNormal(bc,wc,Sc,d.normal),h.face=d,h.barycoord=u}return h}var Nr=class extends ci{constructor(e=null,t=1,n=1,s,r,o,a,l,c=xn,h=xn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var sl=class extends Vn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Do=new Lt,B0=new Lt,Ac=[],z0=new gs,eM=new Lt,Ga=new nn,Wa=new Gs,rl=class extends nn{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new sl(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,eM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new gs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Do),z0.copy(e.boundingBox).applyMatrix4(Do),this.boundingBox.union(z0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Gs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Do),Wa.copy(e.boundingSphere).applyMatrix4(Do),this.boundingSphere.union(Wa)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Ga.geometry=this.geometry,Ga.material=this.material,Ga.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Wa.copy(this.boundingSphere),Wa.applyMatrix4(n),e.ray.intersectsSphere(Wa)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Do),B0.multiplyMatrices(n,Do),Ga.matrixWorld=B0,Ga.raycast(e,Ac);for(let o=0,a=Ac.length;o<a;o++){let l=Ac[o];l.instanceId=r,l.object=this,t.push(l)}Ac.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new sl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Nr(new Float32Array(s*this.count),s,this.count,Mh,Ni));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},kr=new Gs,tM=new tt(.5,.5),Cc=new q,ur=class{constructor(e=new bi,t=new bi,n=new bi,s=new bi,r=new bi,o=new bi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=ki,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],b=r[12],C=r[13],T=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-b).normalize(),s[1].setComponents(c+o,f+h,m+g,R+b).normalize(),s[2].setComponents(c+a,f+u,m+y,R+C).normalize(),s[3].setComponents(c-a,f-u,m-y,R-C).normalize(),n)s[4].setComponents(l,d,p,T).normalize(),s[5].setComponents(c-l,f-d,m-p,R-T).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-T).normalize(),t===ki)s[5].setComponents(c+l,f+d,m+p,R+T).normalize();else if(t===Vo)s[5].setComponents(l,d,p,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),kr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),kr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(kr)}intersectsSprite(e){kr.center.set(0,0,0);let t=tM.distanceTo(e.center);return kr.radius=.7071067811865476+t,kr.applyMatrix4(e.matrixWorld),this.intersectsSphere(kr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Cc.x=s.normal.x>0?e.max.x:e.min.x,Cc.y=s.normal.y>0?e.max.y:e.min.y,Cc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Cc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},V0=new Lt,jc=class i{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];V0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ur),n[s].setFromProjectionMatrix(V0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ur),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Si=class extends Ws{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ft(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Qc=new q,eh=new q,H0=new Lt,Xa=new Dr,Pc=new Gs,ep=new q,G0=new q,Or=class extends Xn{constructor(e=new An,t=new Si){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Qc.fromBufferAttribute(t,s-1),eh.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Qc.distanceTo(eh);e.setAttribute("lineDistance",new Hn(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Pc.copy(n.boundingSphere),Pc.applyMatrix4(s),Pc.radius+=r,e.ray.intersectsSphere(Pc)===!1)return;H0.copy(s).invert(),Xa.copy(e.ray).applyMatrix4(H0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=h.getX(y),b=h.getX(y+1),C=Rc(this,e,Xa,l,m,b,y);C&&t.push(C)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(f),m=Rc(this,e,Xa,l,y,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Rc(this,e,Xa,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Rc(this,e,Xa,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Rc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Qc.fromBufferAttribute(a,s),eh.fromBufferAttribute(a,r),t.distanceSqToSegment(Qc,eh,ep,G0)>n)return;ep.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(ep);if(!(c<e.near||c>e.far))return{distance:c,point:G0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var W0=new q,X0=new q,_s=class extends Or{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)W0.fromBufferAttribute(t,s),X0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+W0.distanceTo(X0);e.setAttribute("lineDistance",new Hn(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ur=class extends Or{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var ol=class extends ci{constructor(e=[],t=Hr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Xs=class extends ci{constructor(e,t,n=Ki,s,r,o,a=xn,l=xn,c,h=Vs,u=1){if(h!==Vs&&h!==qs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Wo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},al=class extends Xs{constructor(e,t=Ki,n=Hr,s,r,o=xn,a=xn,l,c=Vs){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ll=class extends ci{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},dr=class i extends An{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Hn(c,3)),this.setAttribute("normal",new Hn(h,3)),this.setAttribute("uv",new Hn(u,2));function g(y,p,m,b,C,T,R,E,v,A,z){let N=T/v,D=R/A,W=T/2,G=R/2,I=E/2,F=v+1,$=A+1,V=0,le=0,Z=new q;for(let Q=0;Q<$;Q++){let ie=Q*D-G;for(let de=0;de<F;de++){let ue=de*N-W;Z[y]=ue*b,Z[p]=ie*C,Z[m]=I,c.push(Z.x,Z.y,Z.z),Z[y]=0,Z[p]=0,Z[m]=E>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(de/v),u.push(1-Q/A),V+=1}}for(let Q=0;Q<A;Q++)for(let ie=0;ie<v;ie++){let de=d+ie+F*Q,ue=d+ie+F*(Q+1),ee=d+(ie+1)+F*(Q+1),me=d+(ie+1)+F*Q;l.push(de,ue,me),l.push(ue,ee,me),le+=6}a.addGroup(f,le,z),f+=le,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Lc=new q,Ic=new q,tp=new q,kc=new Bs,Fr=class extends An{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Fo*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:m}=kc;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),kc.getNormal(tp),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let b=0;b<3;b++){let C=(b+1)%3,T=u[b],R=u[C],E=kc[h[b]],v=kc[h[C]],A=`${T}_${R}`,z=`${R}_${T}`,N=d.get(z);N?(tp.dot(N.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(v.x,v.y,v.z)),d.set(z,null)):d.has(A)||d.set(A,{index0:c[b],index1:c[C],normal:tp.clone()})}}for(let g of d.values())if(g){let{index0:y,index1:p}=g;Lc.fromBufferAttribute(a,y),Ic.fromBufferAttribute(a,p),f.push(Lc.x,Lc.y,Lc.z),f.push(Ic.x,Ic.y,Ic.z)}this.setAttribute("position",new Hn(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var vs=class i extends An{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],y=[],p=[];for(let m=0;m<h;m++){let b=m*d-o;for(let C=0;C<c;C++){let T=C*u-r;g.push(T,-b,0),y.push(0,0,1),p.push(C/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let b=0;b<a;b++){let C=b+c*m,T=b+c*(m+1),R=b+1+c*(m+1),E=b+1+c*m;f.push(C,T,E),f.push(T,R,E)}this.setIndex(f),this.setAttribute("position",new Hn(g,3)),this.setAttribute("normal",new Hn(y,3)),this.setAttribute("uv",new Hn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},cl=class i extends An{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new q,g=new tt;for(let y=0;y<=s;y++){for(let p=0;p<=n;p++){let m=r+p/n*o;f.x=u*Math.cos(m),f.y=u*Math.sin(m),l.push(f.x,f.y,f.z),c.push(0,0,1),g.x=(f.x/t+1)/2,g.y=(f.y/t+1)/2,h.push(g.x,g.y)}u+=d}for(let y=0;y<s;y++){let p=y*(n+1);for(let m=0;m<n;m++){let b=m+p,C=b,T=b+n+1,R=b+n+2,E=b+1;a.push(C,T,E),a.push(T,R,E)}}this.setIndex(a),this.setAttribute("position",new Hn(l,3)),this.setAttribute("normal",new Hn(c,3)),this.setAttribute("uv",new Hn(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};function Wr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if($0(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if($0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Kn(i){let e={};for(let t=0;t<i.length;t++){let n=Wr(i[t]);for(let s in n)e[s]=n[s]}return e}function $0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function nM(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Bp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:wt.workingColorSpace}var B_={clone:Wr,merge:Kn},iM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,sM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ys=class extends Ws{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=iM,this.fragmentShader=sM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Wr(e.uniforms),this.uniformsGroups=nM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ft().setHex(s.value);break;case"v2":this.uniforms[n].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().fromArray(s.value);break;case"v4":this.uniforms[n].value=new jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new st().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Lt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},th=class extends ys{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Yi=class extends Ws{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ft(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=su,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Hs,this.combine=_h,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},nh=class extends Ws{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=S_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ih=class extends Ws{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function No(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Dc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var fr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sh=class extends fr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sp,endingEnd:sp}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rp:r=e,a=2*t-n;break;case op:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case rp:o=e,l=2*n-t;break;case op:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,b=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,C=(-1-f)*p+(1.5+f)*y+.5*g,T=f*p-f*y;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+b*o[c+R]+C*o[l+R]+T*o[u+R];return r}},rh=class extends fr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},oh=class extends fr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ah=class extends fr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*d+g*2,b=u[m],C=u[m+1],T=e*d+g*2,R=h[T],E=h[T+1],v=oM(n,t,b,R,s);r[g]=z_(v,y,C,E,p)}return r}};function z_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function rM(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function oM(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=z_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=rM(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Mi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=No(t,this.TimeBufferType),this.values=No(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:No(e.times,Array),values:No(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Dc(e.settings)&&(n.settings={inTangents:No(e.settings.inTangents,Array),outTangents:No(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new oh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ah(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ya:t=this.InterpolantFactoryMethodDiscrete;break;case Yc:t=this.InterpolantFactoryMethodLinear;break;case Uc:t=this.InterpolantFactoryMethodSmooth;break;case ip:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ya;case this.InterpolantFactoryMethodLinear:return Yc;case this.InterpolantFactoryMethodSmooth:return Uc;case this.InterpolantFactoryMethodBezier:return ip}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Dc(this.settings)&&(q0(this.settings.inTangents,e),q0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Dc(this.settings)&&(Y0(this.settings.inTangents,e),Y0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&bS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Uc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Dc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function q0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Y0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=Yc;var pr=class extends Mi{constructor(e,t,n){super(e,t,n)}};pr.prototype.ValueTypeName="bool";pr.prototype.ValueBufferType=Array;pr.prototype.DefaultInterpolation=Ya;pr.prototype.InterpolantFactoryMethodLinear=void 0;pr.prototype.InterpolantFactoryMethodSmooth=void 0;var lh=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};lh.prototype.ValueTypeName="color";var ch=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};ch.prototype.ValueTypeName="number";var hh=class extends fr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)si.slerpFlat(r,0,o,c-a,o,c,l);return r}},hl=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new hh(this.times,this.values,this.getValueSize(),e)}};hl.prototype.ValueTypeName="quaternion";hl.prototype.InterpolantFactoryMethodSmooth=void 0;var mr=class extends Mi{constructor(e,t,n){super(e,t,n)}};mr.prototype.ValueTypeName="string";mr.prototype.ValueBufferType=Array;mr.prototype.DefaultInterpolation=Ya;mr.prototype.InterpolantFactoryMethodLinear=void 0;mr.prototype.InterpolantFactoryMethodSmooth=void 0;var uh=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};uh.prototype.ValueTypeName="vector";var dh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},V_=new dh,fh=class{constructor(e){this.manager=e!==void 0?e:V_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};fh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ul=class extends Xn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ft(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},dl=class extends ul{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Xn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ft(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},np=new Lt,K0=new q,Z0=new q,ph=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new Lt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ur,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;K0.setFromMatrixPosition(e.matrixWorld),t.position.copy(K0),Z0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Z0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){np.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(np,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Vo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(np)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Nc=new q,Oc=new si,ps=new q,fl=class extends Xn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Lt,this.projectionMatrix=new Lt,this.projectionMatrixInverse=new Lt,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Nc,Oc,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nc,Oc,ps.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Nc,Oc,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nc,Oc,ps.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},cr=new q,J0=new tt,j0=new tt,ni=class extends fl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Go*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Fo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Go*2*Math.atan(Math.tan(Fo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){cr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(cr.x,cr.y).multiplyScalar(-e/cr.z),cr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(cr.x,cr.y).multiplyScalar(-e/cr.z)}getViewSize(e,t){return this.getViewBounds(e,J0,j0),t.subVectors(j0,J0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Fo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var pl=class extends fl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},ap=class extends ph{constructor(){super(new pl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ml=class extends ul{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Xn.DEFAULT_UP),this.updateMatrix(),this.target=new Xn,this.shadow=new ap}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Oo=-90,Uo=1,$o=class extends Xn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ni(Oo,Uo,e,t);s.layers=this.layers,this.add(s);let r=new ni(Oo,Uo,e,t);r.layers=this.layers,this.add(r);let o=new ni(Oo,Uo,e,t);o.layers=this.layers,this.add(o);let a=new ni(Oo,Uo,e,t);a.layers=this.layers,this.add(a);let l=new ni(Oo,Uo,e,t);l.layers=this.layers,this.add(l);let c=new ni(Oo,Uo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Vo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},mh=class extends ni{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var zp="\\[\\]\\.:\\/",aM=new RegExp("["+zp+"]","g"),Vp="[^"+zp+"]",lM="[^"+zp.replace("\\.","")+"]",cM=/((?:WC+[\/:])*)/.source.replace("WC",Vp),hM=/(WCOD+)?/.source.replace("WCOD",lM),uM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Vp),dM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Vp),fM=new RegExp("^"+cM+hM+uM+dM+"$"),pM=["material","materials","bones","map"],lp=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(aM,"")}static parseTrackName(e){let t=fM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);pM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=lp;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var P3=new Float32Array(1);var qo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=yt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(yt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var qp=class qp{constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};qp.prototype.isMatrix2=!0;var cp=qp;var gl=class extends qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Hp(i,e,t,n){let s=mM(n);switch(t){case Cp:return i*e;case Mh:return i*e/s.components*s.byteLength;case Th:return i*e/s.components*s.byteLength;case yr:return i*e*2/s.components*s.byteLength;case Eh:return i*e*2/s.components*s.byteLength;case Pp:return i*e*3/s.components*s.byteLength;case Ji:return i*e*4/s.components*s.byteLength;case Ah:return i*e*4/s.components*s.byteLength;case vl:case yl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xl:case bl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ph:case Lh:return Math.max(i,16)*Math.max(e,8)/4;case Ch:case Rh:return Math.max(i,8)*Math.max(e,8)/2;case Ih:case kh:case Nh:case Oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Dh:case wl:case Uh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Fh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Bh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case zh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Vh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Hh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Gh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Wh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Xh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case $h:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case qh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Yh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Kh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Zh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Jh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case jh:case Qh:case eu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case tu:case nu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Sl:case iu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mM(i){switch(i){case ui:case Mp:return{byteLength:1,components:1};case Jo:case Tp:case Zi:return{byteLength:2,components:1};case wh:case Sh:return{byteLength:2,components:4};case Ki:case bh:case Ni:return{byteLength:4,components:1};case Ep:case Ap:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function cv(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function _M(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var vM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,xM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,bM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,wM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,SM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,MM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,TM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,EM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,AM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,CM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,PM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,RM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,LM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,IM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,kM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,DM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,NM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,OM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,UM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,FM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,BM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,zM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,VM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,HM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,GM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,WM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,XM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,$M=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qM="gl_FragColor = linearToOutputTexel( gl_FragColor );",YM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,KM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,ZM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,JM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,jM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,QM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,e1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,t1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,n1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,i1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,s1=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,r1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,o1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,a1=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,l1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,c1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,h1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,u1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,d1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,f1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,p1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,m1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,g1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,_1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,v1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,y1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,x1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,b1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,w1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,S1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,M1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,T1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,E1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,A1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,C1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,P1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,R1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,L1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,I1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,k1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,D1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,N1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,O1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,U1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,F1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,B1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,z1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,V1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,H1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,G1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,W1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,X1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,q1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Y1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,K1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Z1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,J1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,j1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Q1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,eT=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,tT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,nT=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,iT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,sT=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,rT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,oT=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,aT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,lT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,hT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,uT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,dT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,fT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,pT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,mT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,gT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_T=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,vT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ST=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,MT=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,TT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ET=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,AT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,CT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,RT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,LT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,IT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,NT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,OT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,FT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,BT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,HT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,GT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,$T=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,KT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ZT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,mt={alphahash_fragment:vM,alphahash_pars_fragment:yM,alphamap_fragment:xM,alphamap_pars_fragment:bM,alphatest_fragment:wM,alphatest_pars_fragment:SM,aomap_fragment:MM,aomap_pars_fragment:TM,batching_pars_vertex:EM,batching_vertex:AM,begin_vertex:CM,beginnormal_vertex:PM,bsdfs:RM,iridescence_fragment:LM,bumpmap_pars_fragment:IM,clipping_planes_fragment:kM,clipping_planes_pars_fragment:DM,clipping_planes_pars_vertex:NM,clipping_planes_vertex:OM,color_fragment:UM,color_pars_fragment:FM,color_pars_vertex:BM,color_vertex:zM,common:VM,defaultnormal_vertex:HM,displacementmap_pars_vertex:GM,displacementmap_vertex:WM,emissivemap_fragment:XM,emissivemap_pars_fragment:$M,colorspace_fragment:qM,colorspace_pars_fragment:YM,envmap_fragment:KM,envmap_common_pars_fragment:ZM,envmap_pars_fragment:JM,envmap_pars_vertex:jM,envmap_physical_pars_fragment:c1,envmap_vertex:QM,fog_vertex:e1,fog_pars_vertex:t1,fog_fragment:n1,fog_pars_fragment:i1,gradientmap_pars_fragment:s1,lightmap_pars_fragment:r1,lights_lambert_fragment:o1,lights_lambert_pars_fragment:a1,lights_pars_begin:l1,lights_toon_fragment:h1,lights_toon_pars_fragment:u1,lights_phong_fragment:d1,lights_phong_pars_fragment:f1,lights_physical_fragment:p1,lights_physical_pars_fragment:m1,lights_fragment_begin:g1,lights_fragment_maps:_1,lights_fragment_end:v1,lightprobes_pars_fragment:y1,logdepthbuf_fragment:x1,logdepthbuf_pars_fragment:b1,logdepthbuf_pars_vertex:w1,logdepthbuf_vertex:S1,map_fragment:M1,map_pars_fragment:T1,map_particle_fragment:E1,map_particle_pars_fragment:A1,metalnessmap_fragment:C1,metalnessmap_pars_fragment:P1,morphinstance_vertex:R1,morphcolor_vertex:L1,morphnormal_vertex:I1,morphtarget_pars_vertex:k1,morphtarget_vertex:D1,normal_fragment_begin:N1,normal_fragment_maps:O1,normal_pars_fragment:U1,normal_pars_vertex:F1,normal_vertex:B1,normalmap_pars_fragment:z1,clearcoat_normal_fragment_begin:V1,clearcoat_normal_fragment_maps:H1,clearcoat_pars_fragment:G1,iridescence_pars_fragment:W1,opaque_fragment:X1,packing:$1,premultiplied_alpha_fragment:q1,project_vertex:Y1,dithering_fragment:K1,dithering_pars_fragment:Z1,roughnessmap_fragment:J1,roughnessmap_pars_fragment:j1,shadowmap_pars_fragment:Q1,shadowmap_pars_vertex:eT,shadowmap_vertex:tT,shadowmask_pars_fragment:nT,skinbase_vertex:iT,skinning_pars_vertex:sT,skinning_vertex:rT,skinnormal_vertex:oT,specularmap_fragment:aT,specularmap_pars_fragment:lT,tonemapping_fragment:cT,tonemapping_pars_fragment:hT,transmission_fragment:uT,transmission_pars_fragment:dT,uv_pars_fragment:fT,uv_pars_vertex:pT,uv_vertex:mT,worldpos_vertex:gT,background_vert:_T,background_frag:vT,backgroundCube_vert:yT,backgroundCube_frag:xT,cube_vert:bT,cube_frag:wT,depth_vert:ST,depth_frag:MT,distance_vert:TT,distance_frag:ET,equirect_vert:AT,equirect_frag:CT,linedashed_vert:PT,linedashed_frag:RT,meshbasic_vert:LT,meshbasic_frag:IT,meshlambert_vert:kT,meshlambert_frag:DT,meshmatcap_vert:NT,meshmatcap_frag:OT,meshnormal_vert:UT,meshnormal_frag:FT,meshphong_vert:BT,meshphong_frag:zT,meshphysical_vert:VT,meshphysical_frag:HT,meshtoon_vert:GT,meshtoon_frag:WT,points_vert:XT,points_frag:$T,shadow_vert:qT,shadow_frag:YT,sprite_vert:KT,sprite_frag:ZT},ke={common:{diffuse:{value:new ft(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ft(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ft(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new ft(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},ws={basic:{uniforms:Kn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.fog]),vertexShader:mt.meshbasic_vert,fragmentShader:mt.meshbasic_frag},lambert:{uniforms:Kn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new ft(0)},envMapIntensity:{value:1}}]),vertexShader:mt.meshlambert_vert,fragmentShader:mt.meshlambert_frag},phong:{uniforms:Kn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new ft(0)},specular:{value:new ft(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:mt.meshphong_vert,fragmentShader:mt.meshphong_frag},standard:{uniforms:Kn([ke.common,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.roughnessmap,ke.metalnessmap,ke.fog,ke.lights,{emissive:{value:new ft(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag},toon:{uniforms:Kn([ke.common,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.gradientmap,ke.fog,ke.lights,{emissive:{value:new ft(0)}}]),vertexShader:mt.meshtoon_vert,fragmentShader:mt.meshtoon_frag},matcap:{uniforms:Kn([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,{matcap:{value:null}}]),vertexShader:mt.meshmatcap_vert,fragmentShader:mt.meshmatcap_frag},points:{uniforms:Kn([ke.points,ke.fog]),vertexShader:mt.points_vert,fragmentShader:mt.points_frag},dashed:{uniforms:Kn([ke.common,ke.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:mt.linedashed_vert,fragmentShader:mt.linedashed_frag},depth:{uniforms:Kn([ke.common,ke.displacementmap]),vertexShader:mt.depth_vert,fragmentShader:mt.depth_frag},normal:{uniforms:Kn([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,{opacity:{value:1}}]),vertexShader:mt.meshnormal_vert,fragmentShader:mt.meshnormal_frag},sprite:{uniforms:Kn([ke.sprite,ke.fog]),vertexShader:mt.sprite_vert,fragmentShader:mt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:mt.background_vert,fragmentShader:mt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:mt.backgroundCube_vert,fragmentShader:mt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:mt.cube_vert,fragmentShader:mt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:mt.equirect_vert,fragmentShader:mt.equirect_frag},distance:{uniforms:Kn([ke.common,ke.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:mt.distance_vert,fragmentShader:mt.distance_frag},shadow:{uniforms:Kn([ke.lights,ke.fog,{color:{value:new ft(0)},opacity:{value:1}}]),vertexShader:mt.shadow_vert,fragmentShader:mt.shadow_frag}};ws.physical={uniforms:Kn([ws.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new ft(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new ft(0)},specularColor:{value:new ft(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag};var ru={r:0,b:0,g:0},JT=new Lt,hv=new st;hv.set(-1,0,0,0,1,0,0,0,1);function jT(i,e,t,n,s,r){let o=new ft(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(b){let C=b.isScene===!0?b.background:null;if(C&&C.isTexture){let T=b.backgroundBlurriness>0;C=e.get(C,T)}return C}function g(b){let C=!1,T=f(b);T===null?p(o,a):T&&T.isColor&&(p(T,1),C=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(b,C){let T=f(C);T&&T.isCubeTexture?(c===void 0&&(c=new nn(new dr(1,1,1),new ys({name:"BackgroundCubeMaterial",uniforms:Wr(ws.backgroundCube.uniforms),vertexShader:ws.backgroundCube.vertexShader,fragmentShader:ws.backgroundCube.fragmentShader,side:ri,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=T,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(JT.makeRotationFromEuler(C.backgroundRotation)).transpose(),T.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(hv),c.material.toneMapped=wt.getTransfer(T.colorSpace)!==Rt,(h!==T||u!==T.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=T,u=T.version,d=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):T&&T.isTexture&&(l===void 0&&(l=new nn(new vs(2,2),new ys({name:"BackgroundMaterial",uniforms:Wr(ws.background.uniforms),vertexShader:ws.background.vertexShader,fragmentShader:ws.background.fragmentShader,side:vr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=T,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=wt.getTransfer(T.colorSpace)!==Rt,T.matrixAutoUpdate===!0&&T.updateMatrix(),l.material.uniforms.uvTransform.value.copy(T.matrix),(h!==T||u!==T.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=T,u=T.version,d=i.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function p(b,C){b.getRGB(ru,Bp(i)),t.buffers.color.setClear(ru.r,ru.g,ru.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,C=1){o.set(b),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,p(o,a)},render:g,addToRenderList:y,dispose:m}}function QT(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,W,G,I,F){let $=!1,V=u(D,I,G,W);r!==V&&(r=V,c(r.object)),$=f(D,I,G,F),$&&g(D,I,G,F),F!==null&&e.update(F,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,T(D,W,G,I),F!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(F).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,W,G,I){let F=I.wireframe===!0,$=n[W.id];$===void 0&&($={},n[W.id]=$);let V=D.isInstancedMesh===!0?D.id:0,le=$[V];le===void 0&&(le={},$[V]=le);let Z=le[G.id];Z===void 0&&(Z={},le[G.id]=Z);let Q=Z[F];return Q===void 0&&(Q=d(l()),Z[F]=Q),Q}function d(D){let W=[],G=[],I=[];for(let F=0;F<t;F++)W[F]=0,G[F]=0,I[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:G,attributeDivisors:I,object:D,attributes:{},index:null}}function f(D,W,G,I){let F=r.attributes,$=W.attributes,V=0,le=G.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=F[Z],de=$[Z];if(de===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;V++}return r.attributesNum!==V||r.index!==I}function g(D,W,G,I){let F={},$=W.attributes,V=0,le=G.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=$[Z];ie===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),F[Z]=de,V++}r.attributes=F,r.attributesNum=V,r.index=I}function y(){let D=r.newAttributes;for(let W=0,G=D.length;W<G;W++)D[W]=0}function p(D){m(D,0)}function m(D,W){let G=r.newAttributes,I=r.enabledAttributes,F=r.attributeDivisors;G[D]=1,I[D]===0&&(i.enableVertexAttribArray(D),I[D]=1),F[D]!==W&&(i.vertexAttribDivisor(D,W),F[D]=W)}function b(){let D=r.newAttributes,W=r.enabledAttributes;for(let G=0,I=W.length;G<I;G++)W[G]!==D[G]&&(i.disableVertexAttribArray(G),W[G]=0)}function C(D,W,G,I,F,$,V){V===!0?i.vertexAttribIPointer(D,W,G,F,$):i.vertexAttribPointer(D,W,G,I,F,$)}function T(D,W,G,I){y();let F=I.attributes,$=G.getAttributes(),V=W.defaultAttributeValues;for(let le in $){let Z=$[le];if(Z.location>=0){let Q=F[le];if(Q===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let ee=ue.buffer,me=ue.type,ge=ue.bytesPerElement,ve=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===bh;if(Q.isInterleavedBufferAttribute){let _e=Q.data,Ge=_e.isInterleavedBuffer===!0?_e.stride:_e.itemSize,Je=Q.offset;if(_e.isInstancedInterleavedBuffer||_e.isInstancedBufferAttribute){for(let Ue=0;Ue<Z.locationSize;Ue++)m(Z.location+Ue,_e.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=_e.meshPerAttribute*_e.count)}else for(let Ue=0;Ue<Z.locationSize;Ue++)p(Z.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ue=0;Ue<Z.locationSize;Ue++)C(Z.location+Ue,de/Z.locationSize,me,ie,Ge*ge,(Je+de/Z.locationSize*Ue)*ge,ve)}else{if(Q.isInstancedBufferAttribute){for(let _e=0;_e<Z.locationSize;_e++)m(Z.location+_e,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let _e=0;_e<Z.locationSize;_e++)p(Z.location+_e);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let _e=0;_e<Z.locationSize;_e++)C(Z.location+_e,de/Z.locationSize,me,ie,de*ge,de/Z.locationSize*_e*ge,ve)}}else if(V!==void 0){let ie=V[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(Z.location,ie);break;case 3:i.vertexAttrib3fv(Z.location,ie);break;case 4:i.vertexAttrib4fv(Z.location,ie);break;default:i.vertexAttrib1fv(Z.location,ie)}}}}b()}function R(){z();for(let D in n){let W=n[D];for(let G in W){let I=W[G];for(let F in I){let $=I[F];for(let V in $)h($[V].object),delete $[V];delete I[F]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let W=n[D.id];for(let G in W){let I=W[G];for(let F in I){let $=I[F];for(let V in $)h($[V].object),delete $[V];delete I[F]}}delete n[D.id]}function v(D){for(let W in n){let G=n[W];for(let I in G){let F=G[I];if(F[D.id]===void 0)continue;let $=F[D.id];for(let V in $)h($[V].object),delete $[V];delete F[D.id]}}}function A(D){for(let W in n){let G=n[W],I=D.isInstancedMesh===!0?D.id:0,F=G[I];if(F!==void 0){for(let $ in F){let V=F[$];for(let le in V)h(V[le].object),delete V[le];delete F[$]}delete G[I],Object.keys(G).length===0&&delete n[W]}}}function z(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:z,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:A,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:p,disableUnusedAttributes:b}}function eE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function tE(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Ji&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let A=v===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==ui&&v!==Ni&&!A&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),T=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:b,maxVaryings:C,maxFragmentUniforms:T,maxSamples:R,samples:E}}function nE(i){let e=this,t=null,n=0,s=!1,r=!1,o=new bi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let b=r?0:n,C=b*4,T=m.clippingState||null;l.value=T,T=h(g,d,C,f);for(let R=0;R!==C;++R)T[R]=t[R];m.clippingState=T,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,T=f;C!==y;++C,T+=4)o.copy(u[C]).applyMatrix4(b,a),o.normal.toArray(p,T),p[T+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var El=class extends wi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ol(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new dr(5,5,5),r=new ys({name:"CubemapFromEquirect",uniforms:Wr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ri,blending:zr});r.uniforms.tEquirect.value=t;let o=new nn(s,r),a=t.minFilter;return t.minFilter===$s&&(t.minFilter=ii),new $o(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},H_=256,iE=3,sE=20,uv=256,dv=16,rE=3,oE=new q,aE=new ft,au=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new $o(1,10,null),this._boxMesh=new nn(new dr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=oE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(aE));let p=new $o(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=X_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=W_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(H_,Op(e))}_fromTexture(e,t){e.mapping===Hr||e.mapping===Zo?this._setSize(e.image.length===0?H_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=G_(e,!1,!1),n=Math.log2(e)-iE;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=G_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Hr||e.mapping===Zo?(this._cubemapMaterial===null&&(this._cubemapMaterial=X_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=W_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=lE(),this._integrationMaterial=cE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/dv);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-rE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(uv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=hE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function G_(i,e,t){return new El(i,{minFilter:$s,generateMipmaps:e,type:Zi,colorSpace:Ka,depthBuffer:t})}function Al(i,e,t){return new ys({name:i,uniforms:e,vertexShader:mt.cube_vert,fragmentShader:t,side:ri,blending:zr,depthTest:!1,depthWrite:!1})}function lE(){return Al("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${uv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function cE(){return Al("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:dv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function hE(){return Al("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${sE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function W_(){return Al("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function X_(){return Al("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function uE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===vh||f===yh)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new El(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===vh||f===yh,y=f===Hr||f===Zo;if(g||y){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new au(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let b=d.image;return g&&b&&b.height>0||y&&b&&l(b)?(n===null&&(n=new au(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===vh?d.mapping=Hr:f===yh&&(d.mapping=Zo),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function dE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&$a("WebGLRenderer: "+n+" extension not supported."),s}}}function fE(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let b=y!==null?y.array.length:p.array.length/3-1,C=p.count>=65535?il:nl,T=new C(Math.ceil(b/3)*6,1),R=T.array;if(y!==null){let v=y.array;m=y.version;for(let A=0,z=0;A<b;A+=3){let N=v[A+0],D=v[A+1],W=v[A+2];R[z++]=N,R[z++]=D,R[z++]=D,R[z++]=W,R[z++]=W,R[z++]=N}}else{m=p.version;for(let v=0,A=0;v<b;v+=3){let z=v+0,N=v+1,D=v+2;R[A++]=z,R[A++]=N,R[A++]=N,R[A++]=D,R[A++]=D,R[A++]=z}}T.version=m;let E=r.get(g);E&&e.remove(E),r.set(g,T)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function pE(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function mE(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function gE(i,e,t){let n=new WeakMap,s=new jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let z=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",z)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),y===!0&&(C=3);let T=a.attributes.position.count*C,R=1;T>e.maxTextureSize&&(R=Math.ceil(T/e.maxTextureSize),T=e.maxTextureSize);let E=new Float32Array(T*R*4*u),v=new ja(E,T,R,u);v.type=Ni,v.needsUpdate=!0;let A=C*4;for(let N=0;N<u;N++){let D=p[N],W=m[N],G=b[N],I=T*R*4*N;for(let F=0;F<D.count;F++){let $=F*A;f===!0&&(s.fromBufferAttribute(D,F),E[I+$+0]=s.x,E[I+$+1]=s.y,E[I+$+2]=s.z,E[I+$+3]=0),g===!0&&(s.fromBufferAttribute(W,F),E[I+$+4]=s.x,E[I+$+5]=s.y,E[I+$+6]=s.z,E[I+$+7]=0),y===!0&&(s.fromBufferAttribute(G,F),E[I+$+8]=s.x,E[I+$+9]=s.y,E[I+$+10]=s.z,E[I+$+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new tt(T,R)},n.set(a,d),a.addEventListener("dispose",z)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function _E(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var vE={[gp]:"LINEAR_TONE_MAPPING",[_p]:"REINHARD_TONE_MAPPING",[vp]:"CINEON_TONE_MAPPING",[yp]:"ACES_FILMIC_TONE_MAPPING",[bp]:"AGX_TONE_MAPPING",[wp]:"NEUTRAL_TONE_MAPPING",[xp]:"CUSTOM_TONE_MAPPING"};function yE(i,e,t,n,s,r){let o=new wi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new An;h.setAttribute("position",new Hn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Hn([0,2,0,0,2,0],2));let u=new th({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new nn(h,u),f=new pl(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,b=null,C=[],T=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let v=0;v<C.length;v++){let A=C[v];A.setSize&&A.setSize(R,E)}},this.setEffects=function(R){C=R,T=C.length>0&&C[0].isRenderPass===!0;let E=o.width,v=o.height;C.length>0&&a===null&&(a=new wi(E,v,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),l=new wi(E,v,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&C.some(z=>z.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new Xs(E,v),r===!0&&(c.format=qs,c.type=Gr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let z=0;z<C.length;z++){let N=C[z];N.setSize&&N.setSize(E,v),A&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,E){if(p||R.toneMapping===xs&&C.length===0)return!1;if(b=E,E!==null){let v=E.width,A=E.height;(o.width!==v||o.height!==A)&&this.setSize(v,A)}return T===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=xs,!0},this.hasRenderPass=function(){return T},this.end=function(R,E){R.toneMapping=m,p=!0;let v=o,A=a;for(let z=0;z<C.length;z++){let N=C[z];N.enabled!==!1&&(N.render(R,A,v,E),N.needsSwap!==!1&&(v=A,A=A===a?l:a))}if(g!==R.outputColorSpace||y!==R.toneMapping){g=R.outputColorSpace,y=R.toneMapping,u.defines={},wt.getTransfer(g)===Rt&&(u.defines.SRGB_TRANSFER="");let z=vE[y];z&&(u.defines[z]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(b),R.render(d,f),b=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var fv=new ci,pv=new Xs(1,1),mv=new al(1),gv=new ja,_v=new Jc,vv=new ol,$_=[],q_=[],Y_=new Float32Array(16),K_=new Float32Array(9),Z_=new Float32Array(4);function ea(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=$_[s];if(r===void 0&&(r=new Float32Array(s),$_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Pn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function cu(i,e){let t=q_[e];t===void 0&&(t=new Int32Array(e),q_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function xE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function bE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2fv(this.addr,e),Pn(t,e)}}function wE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;i.uniform3fv(this.addr,e),Pn(t,e)}}function SE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4fv(this.addr,e),Pn(t,e)}}function ME(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;Z_.set(n),i.uniformMatrix2fv(this.addr,!1,Z_),Pn(t,n)}}function TE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;K_.set(n),i.uniformMatrix3fv(this.addr,!1,K_),Pn(t,n)}}function EE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Pn(t,e)}else{if(Cn(t,n))return;Y_.set(n),i.uniformMatrix4fv(this.addr,!1,Y_),Pn(t,n)}}function AE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function CE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2iv(this.addr,e),Pn(t,e)}}function PE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3iv(this.addr,e),Pn(t,e)}}function RE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4iv(this.addr,e),Pn(t,e)}}function LE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function IE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2uiv(this.addr,e),Pn(t,e)}}function kE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3uiv(this.addr,e),Pn(t,e)}}function DE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4uiv(this.addr,e),Pn(t,e)}}function hu(i){return i.version===0&&(i.compareFunction=Ip,i.needsUpdate=!0),i}function NE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=hu(pv):r=fv,t.setTexture2D(e||r,s)}function OE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||_v,s)}function UE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=hu(mv):r=vv,t.setTextureCube(e||r,s)}function FE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||gv,s)}function BE(i){switch(i){case 5126:return xE;case 35664:return bE;case 35665:return wE;case 35666:return SE;case 35674:return ME;case 35675:return TE;case 35676:return EE;case 5124:case 35670:return AE;case 35667:case 35671:return CE;case 35668:case 35672:return PE;case 35669:case 35673:return RE;case 5125:return LE;case 36294:return IE;case 36295:return kE;case 36296:return DE;case 35678:case 36198:case 36298:case 36306:case 35682:return NE;case 35679:case 36299:case 36307:return OE;case 35680:case 36300:case 36308:case 36293:return UE;case 36289:case 36303:case 36311:case 36292:return FE}}function zE(i,e){i.uniform1fv(this.addr,e)}function VE(i,e){let t=ea(e,this.size,2);i.uniform2fv(this.addr,t)}function HE(i,e){let t=ea(e,this.size,3);i.uniform3fv(this.addr,t)}function GE(i,e){let t=ea(e,this.size,4);i.uniform4fv(this.addr,t)}function WE(i,e){let t=ea(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function XE(i,e){let t=ea(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function $E(i,e){let t=ea(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function qE(i,e){i.uniform1iv(this.addr,e)}function YE(i,e){i.uniform2iv(this.addr,e)}function KE(i,e){i.uniform3iv(this.addr,e)}function ZE(i,e){i.uniform4iv(this.addr,e)}function JE(i,e){i.uniform1uiv(this.addr,e)}function jE(i,e){i.uniform2uiv(this.addr,e)}function QE(i,e){i.uniform3uiv(this.addr,e)}function eA(i,e){i.uniform4uiv(this.addr,e)}function tA(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=hu(pv):o=fv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function nA(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||_v,r[o])}function iA(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=hu(mv):o=vv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function sA(i,e,t){let n=this.cache,s=e.length,r=cu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Pn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||gv,r[o])}function rA(i){switch(i){case 5126:return zE;case 35664:return VE;case 35665:return HE;case 35666:return GE;case 35674:return WE;case 35675:return XE;case 35676:return $E;case 5124:case 35670:return qE;case 35667:case 35671:return YE;case 35668:case 35672:return KE;case 35669:case 35673:return ZE;case 5125:return JE;case 36294:return jE;case 36295:return QE;case 36296:return eA;case 35678:case 36198:case 36298:case 36306:case 35682:return tA;case 35679:case 36299:case 36307:return nA;case 35680:case 36300:case 36308:case 36293:return iA;case 36289:case 36303:case 36311:case 36292:return sA}}var Zp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=BE(t.type)}},Jp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=rA(t.type)}},jp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Yp=/(\w+)(\])?(\[|\.)?/g;function J_(i,e){i.seq.push(e),i.map[e.id]=e}function oA(i,e,t){let n=i.name,s=n.length;for(Yp.lastIndex=0;;){let r=Yp.exec(n),o=Yp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){J_(t,c===void 0?new Zp(a,i,e):new Jp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new jp(a),J_(t,u)),t=u}}}var Qo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);oA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function j_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var aA=37297,lA=0;function cA(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Q_=new st;function hA(i){wt._getMatrix(Q_,wt.workingColorSpace,i);let e=`mat3( ${Q_.elements.map(t=>t.toFixed(4))} )`;switch(wt.getTransfer(i)){case Za:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function ev(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+cA(i.getShaderSource(e),a)}else return r}function uA(i,e){let t=hA(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var dA={[gp]:"Linear",[_p]:"Reinhard",[vp]:"Cineon",[yp]:"ACESFilmic",[bp]:"AgX",[wp]:"Neutral",[xp]:"Custom"};function fA(i,e){let t=dA[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ou=new q;function pA(){wt.getLuminanceCoefficients(ou);let i=ou.x.toFixed(4),e=ou.y.toFixed(4),t=ou.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function mA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function gA(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function _A(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Tl(i){return i!==""}function tv(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function nv(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var vA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Qp(i){return i.replace(vA,yA)}function yA(i,e){let t=mt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Qp(t)}var xA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function iv(i){return i.replace(xA,bA)}function bA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function sv(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var wA={[Br]:"SHADOWMAP_TYPE_PCF",[Yo]:"SHADOWMAP_TYPE_VSM"};function SA(i){return wA[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var MA={[Zo]:"ENVMAP_MODE_REFRACTION"};function TA(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":MA[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var EA={[_h]:"ENVMAP_BLENDING_MULTIPLY",[x_]:"ENVMAP_BLENDING_MIX",[b_]:"ENVMAP_BLENDING_ADD"};function AA(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":EA[i.combine]||"ENVMAP_BLENDING_NONE"}function CA(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=SA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=TA(t),u=AA(t),d=mA(t),f=gA(r),g=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Tl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Tl).join(`
`),p.length>0&&(p+=`
`)):(y=[sv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),p=[sv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==xs?"#define TONE_MAPPING":"",t.toneMapping!==xs?mt.tonemapping_pars_fragment:"",t.toneMapping!==xs?fA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",mt.colorspace_pars_fragment,uA("linearToOutputTexel",t.outputColorSpace),pA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Tl).join(`
`)),o=Qp(o),o=tv(o,t),o=nv(o,t),a=Qp(a),a=tv(a,t),a=nv(a,t),o=iv(o),a=iv(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===kp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===kp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let b=m+y+o,C=m+p+a,T=j_(s,s.VERTEX_SHADER,b),R=j_(s,s.FRAGMENT_SHADER,C);s.attachShader(g,T),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",W=s.getShaderInfoLog(T)||"",G=s.getShaderInfoLog(R)||"",I=D.trim(),F=W.trim(),$=G.trim(),V=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,T,R);else{let Z=ev(s,T,"vertex"),Q=ev(s,R,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+I+`
`+Z+`
`+Q)}else I!==""?Ke("WebGLProgram: Program Info Log:",I):(F===""||$==="")&&(le=!1);le&&(N.diagnostics={runnable:V,programLog:I,vertexShader:{log:F,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(T),s.deleteShader(R),v=new Qo(s,g),A=_A(s,g)}let v;this.getUniforms=function(){return v===void 0&&E(this),v};let A;this.getAttributes=function(){return A===void 0&&E(this),A};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,aA)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=lA++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=T,this.fragmentShader=R,this}var PA=0,em=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new tm(e),t.set(e,n)),n}},tm=class{constructor(e){this.id=PA++,this.code=e,this.usedTimes=0}};function RA(i){return i===yr||i===wl||i===Sl}function LA(i,e,t,n,s,r){let o=new Qa,a=new em,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,A,z,N,D,W){let G=N.fog,I=D.geometry,F=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=e.get(v.envMap||F,$),le=d[v.type],Z=n.precision;v.precision!==null&&(Z=n.getMaxPrecision(v.precision),Z!==v.precision&&Ke("WebGLProgram.getParameters:",v.precision,"not supported, using",Z,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let ue,ee,me,ge;if(le){let Pe=ws[le];ue=Pe.vertexShader,ee=Pe.fragmentShader}else{ue=v.vertexShader,ee=v.fragmentShader;let Pe=a.getVertexShaderStage(v),ut=a.getFragmentShaderStage(v);a.update(v,Pe,ut),me=Pe.id,ge=ut.id}let ve=i.getRenderTarget(),_e=i.state.buffers.depth.getReversed(),Ge=D.isInstancedMesh===!0,Je=D.isBatchedMesh===!0,Ue=!!v.map,ot=!!v.matcap,ht=!!V,at=ht&&V.isPMREMTexture===!0,Zt=!!v.aoMap,Ht=!!v.lightMap,fn=!!v.bumpMap&&v.wireframe===!1,Ut=!!v.normalMap,Dn=!!v.displacementMap,Mt=!!v.emissiveMap,Tn=!!v.metalnessMap,sn=!!v.roughnessMap,pn=v.anisotropy>0,U=v.clearcoat>0,Re=v.diffuseRoughness>0,Ze=v.dispersion>0,ct=v.retroreflectivity>0,Me=v.iridescence>0,Bt=v.sheen>0,We=v.transmission>0,Ye=pn&&!!v.anisotropyMap,P=U&&!!v.clearcoatMap,w=U&&!!v.clearcoatNormalMap,X=U&&!!v.clearcoatRoughnessMap,he=Re&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,xe=Me&&!!v.iridescenceThicknessMap,be=Bt&&!!v.sheenColorMap,te=Bt&&!!v.sheenRoughnessMap,se=!!v.specularMap,pe=!!v.specularColorMap,O=!!v.specularIntensityMap,re=We&&!!v.transmissionMap,ne=We&&!!v.thicknessMap,Te=!!v.gradientMap,ye=!!v.alphaMap,Se=v.alphaTest>0,Xe=!!v.alphaHash,Qe=!!v.extensions,ce=xs;v.toneMapped&&(ve===null||ve.isXRRenderTarget===!0)&&(ce=i.toneMapping);let Be=at?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:ue,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:Z,batching:Je,batchingColor:Je&&D._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&D.instanceColor!==null,instancingMorph:Ge&&D.morphTexture!==null,outputColorSpace:ve===null?i.outputColorSpace:ve.isXRRenderTarget===!0?ve.texture.colorSpace:wt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ue,matcap:ot,envMap:ht,envMapMode:ht&&V.mapping,envMapPMREM:at,envMapMaxLod:at?Be.length-1:null,envMapSize:at?Be[0].width:null,aoMap:Zt,lightMap:Ht,bumpMap:fn,normalMap:Ut,displacementMap:Dn,emissiveMap:Mt,normalMapObjectSpace:Ut&&v.normalMapType===M_,normalMapTangentSpace:Ut&&v.normalMapType===su,packedNormalMap:Ut&&v.normalMapType===su&&RA(v.normalMap.format),metalnessMap:Tn,roughnessMap:sn,anisotropy:pn,anisotropyMap:Ye,clearcoat:U,clearcoatMap:P,clearcoatNormalMap:w,clearcoatRoughnessMap:X,diffuseRoughness:Re,diffuseRoughnessMap:he,dispersion:Ze,retroreflection:ct,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:Bt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:We,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:v.transparent===!1&&v.blending===Ko&&v.alphaToCoverage===!1,alphaMap:ye,alphaTest:Se,alphaHash:Xe,combine:v.combine,mapUv:Ue&&f(v.map.channel),aoMapUv:Zt&&f(v.aoMap.channel),lightMapUv:Ht&&f(v.lightMap.channel),bumpMapUv:fn&&f(v.bumpMap.channel),normalMapUv:Ut&&f(v.normalMap.channel),displacementMapUv:Dn&&f(v.displacementMap.channel),emissiveMapUv:Mt&&f(v.emissiveMap.channel),metalnessMapUv:Tn&&f(v.metalnessMap.channel),roughnessMapUv:sn&&f(v.roughnessMap.channel),anisotropyMapUv:Ye&&f(v.anisotropyMap.channel),clearcoatMapUv:P&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(v.sheenRoughnessMap.channel),specularMapUv:se&&f(v.specularMap.channel),specularColorMapUv:pe&&f(v.specularColorMap.channel),specularIntensityMapUv:O&&f(v.specularIntensityMap.channel),transmissionMapUv:re&&f(v.transmissionMap.channel),thicknessMapUv:ne&&f(v.thicknessMap.channel),alphaMapUv:ye&&f(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ut||pn),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Ue||ye),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&Ut===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:_e,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:W.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ue&&v.map.isVideoTexture===!0&&wt.getTransfer(v.map.colorSpace)===Rt,decodeVideoTextureEmissive:Mt&&v.emissiveMap.isVideoTexture===!0&&wt.getTransfer(v.emissiveMap.colorSpace)===Rt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===hi,flipSided:v.side===ri,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Qe&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&v.extensions.multiDraw===!0||Je)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function y(v){let A=[];if(v.shaderID?A.push(v.shaderID):(A.push(v.customVertexShaderID),A.push(v.customFragmentShaderID)),v.defines!==void 0)for(let z in v.defines)A.push(z),A.push(v.defines[z]);return v.isRawShaderMaterial===!1&&(p(A,v),m(A,v),A.push(i.outputColorSpace)),A.push(v.customProgramCacheKey),A.join()}function p(v,A){v.push(A.precision),v.push(A.outputColorSpace),v.push(A.envMapMode),v.push(A.envMapPMREM),v.push(A.envMapMaxLod),v.push(A.envMapSize),v.push(A.mapUv),v.push(A.alphaMapUv),v.push(A.lightMapUv),v.push(A.aoMapUv),v.push(A.bumpMapUv),v.push(A.normalMapUv),v.push(A.displacementMapUv),v.push(A.emissiveMapUv),v.push(A.metalnessMapUv),v.push(A.roughnessMapUv),v.push(A.anisotropyMapUv),v.push(A.clearcoatMapUv),v.push(A.clearcoatNormalMapUv),v.push(A.clearcoatRoughnessMapUv),v.push(A.diffuseRoughnessMapUv),v.push(A.iridescenceMapUv),v.push(A.iridescenceThicknessMapUv),v.push(A.sheenColorMapUv),v.push(A.sheenRoughnessMapUv),v.push(A.specularMapUv),v.push(A.specularColorMapUv),v.push(A.specularIntensityMapUv),v.push(A.transmissionMapUv),v.push(A.thicknessMapUv),v.push(A.combine),v.push(A.fogExp2),v.push(A.sizeAttenuation),v.push(A.morphTargetsCount),v.push(A.numSunLights),v.push(A.numDirLights),v.push(A.numPointLights),v.push(A.numSpotLights),v.push(A.numSpotLightMaps),v.push(A.numHemiLights),v.push(A.numRectAreaLights),v.push(A.numSunLightShadows),v.push(A.numDirLightShadows),v.push(A.numPointLightShadows),v.push(A.numSpotLightShadows),v.push(A.numSpotLightShadowsWithMaps),v.push(A.numLightProbes),v.push(A.numLightProbeGrids),v.push(A.shadowMapType),v.push(A.toneMapping),v.push(A.numClippingPlanes),v.push(A.numClipIntersection),v.push(A.depthPacking)}function m(v,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let A=d[v.type],z;if(A){let N=ws[A];z=B_.clone(N.uniforms)}else z=v.uniforms;return z}function C(v,A){let z=h.get(A);return z!==void 0?++z.usedTimes:(z=new CA(i,A,v,s),c.push(z),h.set(A,z)),z}function T(v){if(--v.usedTimes===0){let A=c.indexOf(v);c[A]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:b,acquireProgram:C,releaseProgram:T,releaseShaderCache:R,programs:c,dispose:E}}function IA(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function kA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function rv(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function ov(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let b=i[e];return b===void 0?(b={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},i[e]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=g,b.materialVariant=o(d),b.groupOrder=y,b.renderOrder=d.renderOrder,b.z=p,b.group=m),e++,b}function l(d,f,g,y,p,m,b){b.reversedDepth===!0&&(p=-p);let C=a(d,f,g,y,p,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(d,f,g,y,p,m){let b=a(d,f,g,y,p,m);g.transmission>0?n.unshift(b):g.transparent===!0?s.unshift(b):t.unshift(b)}function h(d,f){t.length>1&&t.sort(d||kA),n.length>1&&n.sort(f||rv),s.length>1&&s.sort(f||rv)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function DA(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new ov,i.set(n,[o])):s>=r.length?(o=new ov,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function NA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new ft};break;case"SpotLight":t={position:new q,direction:new q,color:new ft,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new ft,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,skyColor:new ft,groundColor:new ft};break;case"RectAreaLight":t={color:new ft,position:new q,halfWidth:new q,halfHeight:new q};break}return i[e.id]=t,t}}}function OA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var UA=0;function FA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function BA(i){let e=new NA,t=OA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new q);let s=new q,r=new Lt,o=new Lt;function a(c){let h=0,u=0,d=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,b=0,C=0,T=0,R=0,E=0,v=0,A=0,z=0,N=0;c.sort(FA);for(let W=0,G=c.length;W<G;W++){let I=c[W],F=I.color,$=I.intensity,V=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===yr?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=F.r*$,u+=F.g*$,d+=F.b*$;else if(I.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(I.sh.coefficients[Z],$);N++}else if(I.isSunLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=le;let de=Q.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[y+ue]=Q.getMatrix(ue),n.sunShadowCascade[y+ue]=Q._cascadeData[ue];y+=de,g++}n.sun[f]=Z,f++}else if(I.isDirectionalLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[p]=ie,n.directionalShadowMap[p]=le,n.directionalShadowMatrix[p]=I.shadow.matrix,R++}n.directional[p]=Z,p++}else if(I.isSpotLight){let Z=e.get(I);Z.position.setFromMatrixPosition(I.matrixWorld),Z.color.copy(F).multiplyScalar($),Z.distance=V,Z.coneCos=Math.cos(I.angle),Z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Z.decay=I.decay,n.spot[b]=Z;let Q=I.shadow;if(I.map&&(n.spotLightMap[A]=I.map,A++,Q.updateMatrices(I),I.castShadow&&z++),n.spotLightMatrix[b]=Q.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[b]=ie,n.spotShadowMap[b]=le,v++}b++}else if(I.isRectAreaLight){let Z=e.get(I);Z.color.copy(F).multiplyScalar($),Z.halfWidth.set(I.width*.5,0,0),Z.halfHeight.set(0,I.height*.5,0),n.rectArea[C]=Z,C++}else if(I.isPointLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),Z.distance=I.distance,Z.decay=I.decay,I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=le,n.pointShadowMatrix[m]=I.shadow.matrix,E++}n.point[m]=Z,m++}else if(I.isHemisphereLight){let Z=e.get(I);Z.skyColor.copy(I.color).multiplyScalar($),Z.groundColor.copy(I.groundColor).multiplyScalar($),n.hemi[T]=Z,T++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ke.LTC_FLOAT_1,n.rectAreaLTC2=ke.LTC_FLOAT_2):(n.rectAreaLTC1=ke.LTC_HALF_1,n.rectAreaLTC2=ke.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==b||D.rectAreaLength!==C||D.hemiLength!==T||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==E||D.numSpotShadows!==v||D.numSpotMaps!==A||D.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=p,n.spot.length=b,n.rectArea.length=C,n.point.length=m,n.hemi.length=T,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+A-z,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=N,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=b,D.rectAreaLength=C,D.hemiLength=T,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=E,D.numSpotShadows=v,D.numSpotMaps=A,D.numLightProbes=N,n.version=UA++)}function l(c,h){let u=0,d=0,f=0,g=0,y=0,p=0,m=h.matrixWorldInverse;for(let b=0,C=c.length;b<C;b++){let T=c[b];if(T.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(m),u++}else if(T.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(T.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(T.isRectAreaLight){let R=n.rectArea[y];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(T.width*.5,0,0),R.halfHeight.set(0,T.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(T.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:n}}function av(i){let e=new BA(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function zA(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new av(i),e.set(s,[a])):r>=o.length?(a=new av(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var VA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,HA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,GA=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],WA=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],lv=new Lt,Ml=new q,Kp=new q;function XA(i,e,t){let n=new ur,s=new tt,r=new tt,o=new jt,a=new nh,l=new ih,c={},h=t.maxTextureSize,u={[vr]:ri,[ri]:vr,[hi]:hi},d=new ys({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:VA,fragmentShader:HA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new An;g.setAttribute("position",new Vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new nn(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Br;let m=this.type;this.render=function(E,v,A){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===t_&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Br);let z=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),W=i.state;W.setBlending(zr),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let G=m!==this.type;G&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(F=>F.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,F=E.length;I<F;I++){let $=E[I],V=$.shadow;if(V===void 0){Ke("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let le=V.getFrameExtents();s.multiply(le),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,V.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=Z,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Yo){if($.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new wi(s.x,s.y,{format:yr,type:Zi,minFilter:ii,magFilter:ii,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new Xs(s.x,s.y,Ni),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=Vs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=xn,V.map.depthTexture.magFilter=xn}else $.isPointLight?(V.map=new El(s.x),V.map.depthTexture=new al(s.x,Ki)):(V.map=new wi(s.x,s.y),V.map.depthTexture=new Xs(s.x,s.y,Ki)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=Vs,this.type===Br?(V.map.depthTexture.compareFunction=Z?Lp:Rp,V.map.depthTexture.minFilter=ii,V.map.depthTexture.magFilter=ii):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=xn,V.map.depthTexture.magFilter=xn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,A);let ie=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:A.layers;for(let de=0;de<Q;de++){let ue=V.getCamera(de);if($.isPointLight){let ee=V.camera,me=V.matrix,ge=$.distance||ee.far;ge!==ee.far&&(ee.far=ge,ee.updateProjectionMatrix()),Ml.setFromMatrixPosition($.matrixWorld),ee.position.copy(Ml),Kp.copy(ee.position),Kp.add(GA[de]),ee.up.copy(WA[de]),ee.lookAt(Kp),ee.updateMatrixWorld(),me.makeTranslation(-Ml.x,-Ml.y,-Ml.z),lv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(lv,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,de),i.clear();else{de===0&&(i.setRenderTarget(V.map),i.clear());let ee=V.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),W.viewport(o)}n=V.getFrustum(de),T(v,A,ue,$,ie,this.type)}V.isPointLightShadow!==!0&&this.type===Yo&&b(V,A),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(z,N,D)};function b(E,v){let A=e.update(y);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new wi(s.x,s.y,{format:yr,type:Zi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(v,null,A,d,y,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(v,null,A,f,y,null)}function C(E,v,A,z){let N=null,D=A.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)N=D;else if(N=A.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let W=N.uuid,G=v.uuid,I=c[W];I===void 0&&(I={},c[W]=I);let F=I[G];F===void 0&&(F=N.clone(),I[G]=F,v.addEventListener("dispose",R)),N=F}if(N.visible=v.visible,N.wireframe=v.wireframe,z===Yo?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:u[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,A.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let W=i.properties.get(N);W.light=A}return N}function T(E,v,A,z,N,D){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Yo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,E.matrixWorld);let I=e.update(E),F=E.material;if(Array.isArray(F)){let $=I.groups;for(let V=0,le=$.length;V<le;V++){let Z=$[V],Q=F[Z.materialIndex];if(Q&&Q.visible){let ie=C(E,Q,z,D);E.onBeforeShadow(i,E,v,A,I,ie,Z),i.renderBufferDirect(A,null,I,ie,E,Z),E.onAfterShadow(i,E,v,A,I,ie,Z)}}}else if(F.visible){let $=C(E,F,z,D);E.onBeforeShadow(i,E,v,A,I,$,null),i.renderBufferDirect(A,null,I,$,E,null),E.onAfterShadow(i,E,v,A,I,$,null)}}let G=E.children;for(let I=0,F=G.length;I<F;I++)T(G[I],v,A,z,N,D)}function R(E){E.target.removeEventListener("dispose",R);for(let A in c){let z=c[A],N=E.target.uuid;N in z&&(z[N].dispose(),delete z[N])}}}function $A(i,e){function t(){let O=!1,re=new jt,ne=null,Te=new jt(0,0,0,0);return{setMask:function(ye){ne!==ye&&!O&&(i.colorMask(ye,ye,ye,ye),ne=ye)},setLocked:function(ye){O=ye},setClear:function(ye,Se,Xe,Qe,ce){ce===!0&&(ye*=Qe,Se*=Qe,Xe*=Qe),re.set(ye,Se,Xe,Qe),Te.equals(re)===!1&&(i.clearColor(ye,Se,Xe,Qe),Te.copy(re))},reset:function(){O=!1,ne=null,Te.set(-1,0,0,0)}}}function n(){let O=!1,re=!1,ne=null,Te=null,ye=null;return{setReversed:function(Se){if(re!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Qe=ye;ye=null,this.setClear(Qe)}},getReversed:function(){return re},setTest:function(Se){Se?_e(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=N_[Se]),Te!==Se){switch(Se){case Bc:i.depthFunc(i.NEVER);break;case zc:i.depthFunc(i.ALWAYS);break;case Vc:i.depthFunc(i.LESS);break;case zo:i.depthFunc(i.LEQUAL);break;case Hc:i.depthFunc(i.EQUAL);break;case Gc:i.depthFunc(i.GEQUAL);break;case Wc:i.depthFunc(i.GREATER);break;case Xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ye!==Se&&(ye=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){O=!1,ne=null,Te=null,ye=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Te=null,ye=null,Se=null,Xe=null,Qe=null,ce=null;return{setTest:function(Be){O||(Be?_e(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(Be){re!==Be&&!O&&(i.stencilMask(Be),re=Be)},setFunc:function(Be,et,Pe){(ne!==Be||Te!==et||ye!==Pe)&&(i.stencilFunc(Be,et,Pe),ne=Be,Te=et,ye=Pe)},setOp:function(Be,et,Pe){(Se!==Be||Xe!==et||Qe!==Pe)&&(i.stencilOp(Be,et,Pe),Se=Be,Xe=et,Qe=Pe)},setLocked:function(Be){O=Be},setClear:function(Be){ce!==Be&&(i.clearStencil(Be),ce=Be)},reset:function(){O=!1,re=null,ne=null,Te=null,ye=null,Se=null,Xe=null,Qe=null,ce=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,b=null,C=null,T=null,R=null,E=null,v=null,A=new ft(0,0,0),z=0,N=!1,D=null,W=null,G=null,I=null,F=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,le=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),V=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),V=le>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),ee=new jt().fromArray(de),me=new jt().fromArray(ue);function ge(O,re,ne,Te){let ye=new Uint8Array(4),Se=i.createTexture();i.bindTexture(O,Se),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xe=0;Xe<ne;Xe++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(re+Xe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return Se}let ve={};ve[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_e(i.DEPTH_TEST),o.setFunc(zo),fn(!1),Ut(hp),_e(i.CULL_FACE),Zt(zr);function _e(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function Ge(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function Je(O,re){return d[O]!==re?(i.bindFramebuffer(O,re),d[O]=re,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=re),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Ue(O,re){let ne=g,Te=!1;if(O){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let ye=O.textures;if(ne.length!==ye.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,Xe=ye.length;Se<Xe;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=ye.length,Te=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ne)}function ot(O){return y!==O?(i.useProgram(O),y=O,!0):!1}let ht={[Vr]:i.FUNC_ADD,[i_]:i.FUNC_SUBTRACT,[s_]:i.FUNC_REVERSE_SUBTRACT};ht[r_]=i.MIN,ht[o_]=i.MAX;let at={[a_]:i.ZERO,[l_]:i.ONE,[c_]:i.SRC_COLOR,[pp]:i.SRC_ALPHA,[m_]:i.SRC_ALPHA_SATURATE,[f_]:i.DST_COLOR,[u_]:i.DST_ALPHA,[h_]:i.ONE_MINUS_SRC_COLOR,[mp]:i.ONE_MINUS_SRC_ALPHA,[p_]:i.ONE_MINUS_DST_COLOR,[d_]:i.ONE_MINUS_DST_ALPHA,[g_]:i.CONSTANT_COLOR,[__]:i.ONE_MINUS_CONSTANT_COLOR,[v_]:i.CONSTANT_ALPHA,[y_]:i.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,re,ne,Te,ye,Se,Xe,Qe,ce,Be){if(O===zr){p===!0&&(Ge(i.BLEND),p=!1);return}if(p===!1&&(_e(i.BLEND),p=!0),O!==n_){if(O!==m||Be!==N){if((b!==Vr||R!==Vr)&&(i.blendEquation(i.FUNC_ADD),b=Vr,R=Vr),Be)switch(O){case Ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case up:i.blendFunc(i.ONE,i.ONE);break;case dp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case fp:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:it("WebGLState: Invalid blending: ",O);break}else switch(O){case Ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case up:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case dp:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case fp:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",O);break}C=null,T=null,E=null,v=null,A.set(0,0,0),z=0,m=O,N=Be}return}ye=ye||re,Se=Se||ne,Xe=Xe||Te,(re!==b||ye!==R)&&(i.blendEquationSeparate(ht[re],ht[ye]),b=re,R=ye),(ne!==C||Te!==T||Se!==E||Xe!==v)&&(i.blendFuncSeparate(at[ne],at[Te],at[Se],at[Xe]),C=ne,T=Te,E=Se,v=Xe),(Qe.equals(A)===!1||ce!==z)&&(i.blendColor(Qe.r,Qe.g,Qe.b,ce),A.copy(Qe),z=ce),m=O,N=!1}function Ht(O,re){O.side===hi?Ge(i.CULL_FACE):_e(i.CULL_FACE);let ne=O.side===ri;re&&(ne=!ne),fn(ne),O.blending===Ko&&O.transparent===!1?Zt(zr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Mt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?_e(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function fn(O){D!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),D=O)}function Ut(O){O!==Q0?(_e(i.CULL_FACE),O!==W&&(O===hp?i.cullFace(i.BACK):O===e_?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),W=O}function Dn(O){O!==G&&(V&&i.lineWidth(O),G=O)}function Mt(O,re,ne){O?(_e(i.POLYGON_OFFSET_FILL),(I!==re||F!==ne)&&(I=re,F=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):Ge(i.POLYGON_OFFSET_FILL)}function Tn(O){O?_e(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function sn(O){O===void 0&&(O=i.TEXTURE0+$-1),Q!==O&&(i.activeTexture(O),Q=O)}function pn(O,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+$-1:ne=Q);let Te=ie[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ie[ne]=Te),(Te.type!==O||Te.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(O,re||ve[O]),Te.type=O,Te.texture=re)}function U(){let O=ie[Q];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){try{i.compressedTexImage2D(...arguments)}catch(O){it("WebGLState:",O)}}function Ze(){try{i.compressedTexImage3D(...arguments)}catch(O){it("WebGLState:",O)}}function ct(){try{i.texSubImage2D(...arguments)}catch(O){it("WebGLState:",O)}}function Me(){try{i.texSubImage3D(...arguments)}catch(O){it("WebGLState:",O)}}function Bt(){try{i.compressedTexSubImage2D(...arguments)}catch(O){it("WebGLState:",O)}}function We(){try{i.compressedTexSubImage3D(...arguments)}catch(O){it("WebGLState:",O)}}function Ye(){try{i.texStorage2D(...arguments)}catch(O){it("WebGLState:",O)}}function P(){try{i.texStorage3D(...arguments)}catch(O){it("WebGLState:",O)}}function w(){try{i.texImage2D(...arguments)}catch(O){it("WebGLState:",O)}}function X(){try{i.texImage3D(...arguments)}catch(O){it("WebGLState:",O)}}function he(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function oe(O,re){u[O]!==re&&(i.pixelStorei(O,re),u[O]=re)}function xe(O){ee.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function be(O){me.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(O);Te===void 0&&(Te=i.getUniformBlockIndex(re,O.name),i.uniformBlockBinding(re,Te,Te),ne.set(O,Te))}function se(O,re,ne){let ye=c.get(re).get(O);l[ye]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,ne),l[ye]=ne)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ie={},d={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,b=null,C=null,T=null,R=null,E=null,v=null,A=new ft(0,0,0),z=0,N=!1,D=null,W=null,G=null,I=null,F=null,ee.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_e,disable:Ge,bindFramebuffer:Je,drawBuffers:Ue,useProgram:ot,setBlending:Zt,setMaterial:Ht,setFlipSided:fn,setCullFace:Ut,setLineWidth:Dn,setPolygonOffset:Mt,setScissorTest:Tn,activeTexture:sn,bindTexture:pn,unbindTexture:U,compressedTexImage2D:Re,compressedTexImage3D:Ze,texImage2D:w,texImage3D:X,pixelStorei:oe,getParameter:he,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Ye,texStorage3D:P,texSubImage2D:ct,texSubImage3D:Me,compressedTexSubImage2D:Bt,compressedTexSubImage3D:We,scissor:xe,viewport:be,reset:pe}}function qA(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,w){return p?new OffscreenCanvas(P,w):Ja("canvas")}function b(P,w,X){let he=1,oe=Ye(P);if((oe.width>X||oe.height>X)&&(he=X/Math.max(oe.width,oe.height)),he<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let xe=Math.floor(he*oe.width),be=Math.floor(he*oe.height);d===void 0&&(d=m(xe,be));let te=w?m(xe,be):d;return te.width=xe,te.height=be,te.getContext("2d").drawImage(P,0,0,xe,be),Ke("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+be+")."),te}else return"data"in P&&Ke("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function C(P){return P.generateMipmaps}function T(P){i.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(P,w,X,he,oe,xe=!1){if(P!==null){if(i[P]!==void 0)return i[P];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let be;he&&(be=e.get("EXT_texture_norm16"),be||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=w;if(w===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===i.SHORT&&be&&(te=be.R16_SNORM_EXT)),w===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),w===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===i.SHORT&&be&&(te=be.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),w===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),w===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),w===i.RGB&&(X===i.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===i.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),w===i.RGBA){let se=xe?Za:wt.getTransfer(oe);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=se===Rt?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===i.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(P,w){let X;return P?w===null||w===Ki||w===Gr?X=i.DEPTH24_STENCIL8:w===Ni?X=i.DEPTH32F_STENCIL8:w===Jo&&(X=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ki||w===Gr?X=i.DEPTH_COMPONENT24:w===Ni?X=i.DEPTH_COMPONENT32F:w===Jo&&(X=i.DEPTH_COMPONENT16),X}function A(P,w){return C(P)===!0||P.isFramebufferTexture&&P.minFilter!==xn&&P.minFilter!==ii?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function z(P){let w=new WeakRef(P);n.get(P).__ref=w,g.add(w),y.register(P,w,w)}function N(P){let w=n.get(P).__ref;w!==void 0&&(g.delete(w),y.unregister(w))}function D(P){G(P.target)}function W(P){I(P.target)}function G(P){P.removeEventListener("dispose",D),N(P),$(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function I(P){P.removeEventListener("dispose",W),N(P),le(P)}function F(){for(let P of g){let w=P.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):G(w))}g.clear(),u.clear()}function $(P){let w=n.get(P);if(w.__webglInit===void 0)return;let X=P.source,he=f.get(X);if(he){let oe=he[w.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(P),Object.keys(he).length===0&&f.delete(X)}n.remove(P)}function V(P){let w=n.get(P);i.deleteTexture(w.__webglTexture);let X=P.source,he=f.get(X);delete he[w.__cacheKey],o.memory.textures--}function le(P){let w=n.get(P);w.__depthDisposeCallback&&w.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&G(X),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(w.__webglFramebuffer[oe]))for(let xe=0;xe<w.__webglFramebuffer[oe].length;xe++)i.deleteFramebuffer(w.__webglFramebuffer[oe][xe]);else i.deleteFramebuffer(w.__webglFramebuffer[oe]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[oe])}else{if(Array.isArray(w.__webglFramebuffer))for(let oe=0;oe<w.__webglFramebuffer.length;oe++)i.deleteFramebuffer(w.__webglFramebuffer[oe]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let oe=0;oe<w.__webglColorRenderbuffer.length;oe++)w.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[oe]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let he=P.textures;for(let oe=0,xe=he.length;oe<xe;oe++){let be=n.get(he[oe]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(he[oe])}n.remove(P)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(P){Z=P}function ue(){let P=Z;return P>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function ee(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.mipmapsAutoUpdate),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function me(P,w){let X=n.get(P);if(P.isVideoTexture&&Bt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let he=P.image;if(he===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(X,P,w);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+w)}function ge(P,w){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ht(X,P,w);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+w)}function ve(P,w){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Ht(X,P,w);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+w)}function _e(P,w){let X=n.get(P);if(P.version>0&&X.__version!==P.version){fn(X,P,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+w)}let Ge={[$c]:i.REPEAT,[ms]:i.CLAMP_TO_EDGE,[qc]:i.MIRRORED_REPEAT},Je={[xn]:i.NEAREST,[w_]:i.NEAREST_MIPMAP_NEAREST,[_l]:i.NEAREST_MIPMAP_LINEAR,[ii]:i.LINEAR,[xh]:i.LINEAR_MIPMAP_NEAREST,[$s]:i.LINEAR_MIPMAP_LINEAR},Ue={[E_]:i.NEVER,[Ip]:i.ALWAYS,[A_]:i.LESS,[Rp]:i.LEQUAL,[C_]:i.EQUAL,[Lp]:i.GEQUAL,[P_]:i.GREATER,[R_]:i.NOTEQUAL};function ot(P,w){if(w.type===Ni&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===ii||w.magFilter===xh||w.magFilter===_l||w.magFilter===$s||w.minFilter===ii||w.minFilter===xh||w.minFilter===_l||w.minFilter===$s)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,Ge[w.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,Ge[w.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,Ge[w.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,Je[w.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,Je[w.minFilter]),w.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,Ue[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===xn||w.minFilter!==_l&&w.minFilter!==$s||w.type===Ni&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function ht(P,w){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",D),z(w));let he=w.source,oe=f.get(he);oe===void 0&&(oe={},f.set(he,oe));let xe=ee(w);if(xe!==P.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[xe].usedTimes++;let be=oe[P.__cacheKey];be!==void 0&&(oe[P.__cacheKey].usedTimes--,be.usedTimes===0&&V(w)),P.__cacheKey=xe,P.__webglTexture=oe[xe].texture}return X}function at(P,w,X){return Math.floor(Math.floor(P/X)/w)}function Zt(P,w,X,he){let xe=P.updateRanges;if(xe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,X,he,w.data);else{xe.sort((O,re)=>O.start-re.start);let be=0;for(let O=1;O<xe.length;O++){let re=xe[be],ne=xe[O],Te=re.start+re.count,ye=at(ne.start,w.width,4),Se=at(re.start,w.width,4);ne.start<=Te+1&&ye===Se&&at(ne.start+ne.count-1,w.width,4)===ye?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,xe[be]=ne)}xe.length=be+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let O=0,re=xe.length;O<re;O++){let ne=xe[O],Te=Math.floor(ne.start/4),ye=Math.ceil(ne.count/4),Se=Te%w.width,Xe=Math.floor(Te/w.width),Qe=ye,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(i.TEXTURE_2D,0,Se,Xe,Qe,ce,X,he,w.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Ht(P,w,X){let he=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(he=i.TEXTURE_3D);let oe=ht(P,w),xe=w.source;t.bindTexture(he,P.__webglTexture,i.TEXTURE0+X);let be=n.get(xe);if(xe.version!==be.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ce=wt.getPrimaries(wt.workingColorSpace),Be=w.colorSpace===Ys?null:wt.getPrimaries(w.colorSpace),et=w.colorSpace===Ys||ce===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let se=b(w.image,!1,s.maxTextureSize);se=We(w,se);let pe=r.convert(w.format,w.colorSpace),O=r.convert(w.type),re=E(w.internalFormat,pe,O,w.normalized,w.colorSpace,w.isVideoTexture);ot(he,w);let ne,Te=w.mipmaps,ye=w.isVideoTexture!==!0,Se=be.__version===void 0||oe===!0,Xe=xe.dataReady,Qe=A(w,se);if(w.isDepthTexture)re=v(w.format===qs,w.type),Se&&(ye?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(w.isDataTexture)if(Te.length>0){ye&&Se&&t.texStorage2D(i.TEXTURE_2D,Qe,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],ye?Xe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);w.generateMipmaps=!1}else ye?(Se&&t.texStorage2D(i.TEXTURE_2D,Qe,re,se.width,se.height),Xe&&Zt(w,se,pe,O)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ye&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Qe,re,Te[0].width,Te[0].height,se.depth);for(let ce=0,Be=Te.length;ce<Be;ce++)if(ne=Te[ce],w.format!==Ji)if(pe!==null)if(ye){if(Xe)if(w.layerUpdates.size>0){let et=Hp(ne.width,ne.height,w.format,w.type);for(let Pe of w.layerUpdates){let ut=ne.data.subarray(Pe*et/ne.data.BYTES_PER_ELEMENT,(Pe+1)*et/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Pe,ne.width,ne.height,1,pe,ut)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Xe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,O,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,O,ne.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ye&&Se&&t.texStorage2D(i.TEXTURE_2D,Qe,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],w.format!==Ji?pe!==null?ye?Xe&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Xe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(i.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(w.isDataArrayTexture)if(ye){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Qe,re,se.width,se.height,se.depth),Xe)if(w.layerUpdates.size>0){let ce=Hp(se.width,se.height,w.format,w.type);for(let Be of w.layerUpdates){let et=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,O,et)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(w.isData3DTexture)ye?(Se&&t.texStorage3D(i.TEXTURE_3D,Qe,re,se.width,se.height,se.depth),Xe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(w.isFramebufferTexture){if(Se)if(ye)t.texStorage2D(i.TEXTURE_2D,Qe,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let et=0;et<Qe;et++)t.texImage2D(i.TEXTURE_2D,et,re,ce,Be,0,pe,O,null),ce>>=1,Be>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),u.add(w),ce.onpaint=Be=>{let et=Be.changedElements;for(let Pe of u)et.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let et=i.RGBA,Pe=i.RGBA,ut=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,et,Pe,ut,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ye&&Se){let ce=Ye(Te[0]);t.texStorage2D(i.TEXTURE_2D,Qe,re,ce.width,ce.height)}for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],ye?Xe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(i.TEXTURE_2D,ce,re,pe,O,ne);w.generateMipmaps=!1}else if(ye){if(Se){let ce=Ye(se);t.texStorage2D(i.TEXTURE_2D,Qe,re,ce.width,ce.height)}Xe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,O,se);C(w)&&w.mipmapsAutoUpdate===!0&&T(he),be.__version=xe.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function fn(P,w,X){if(w.image.length!==6)return;let he=ht(P,w),oe=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+X);let xe=n.get(oe);if(oe.version!==xe.__version||he===!0){t.activeTexture(i.TEXTURE0+X);let be=wt.getPrimaries(wt.workingColorSpace),te=w.colorSpace===Ys?null:wt.getPrimaries(w.colorSpace),se=w.colorSpace===Ys||be===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=w.isCompressedTexture||w.image[0].isCompressedTexture,O=w.image[0]&&w.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!pe&&!O?re[Pe]=b(w.image[Pe],!0,s.maxCubemapSize):re[Pe]=O?w.image[Pe].image:w.image[Pe],re[Pe]=We(w,re[Pe]);let ne=re[0],Te=r.convert(w.format,w.colorSpace),ye=r.convert(w.type),Se=E(w.internalFormat,Te,ye,w.normalized,w.colorSpace),Xe=w.isVideoTexture!==!0,Qe=xe.__version===void 0||he===!0,ce=oe.dataReady,Be=A(w,ne);ot(i.TEXTURE_CUBE_MAP,w);let et;if(w.isDepthTexture){if(Se=v(w.format===qs,w.type),Qe)if(Xe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ne.width,ne.height,0,Te,ye,null)}else if(pe){Xe&&Qe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){et=re[Pe].mipmaps;for(let ut=0;ut<et.length;ut++){let Gt=et[ut];w.format!==Ji?Te!==null?Xe?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut,0,0,Gt.width,Gt.height,Te,Gt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut,Se,Gt.width,Gt.height,0,Gt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut,0,0,Gt.width,Gt.height,Te,ye,Gt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut,Se,Gt.width,Gt.height,0,Te,ye,Gt.data)}}}else{if(et=w.mipmaps,Xe&&Qe){et.length>0&&Be++;let Pe=Ye(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){Xe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Te,ye,re[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,re[Pe].width,re[Pe].height,0,Te,ye,re[Pe].data);for(let ut=0;ut<et.length;ut++){let Zn=et[ut].image[Pe].image;Xe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut+1,0,0,Zn.width,Zn.height,Te,ye,Zn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut+1,Se,Zn.width,Zn.height,0,Te,ye,Zn.data)}}else{Xe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,ye,re[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,ye,re[Pe]);for(let ut=0;ut<et.length;ut++){let Gt=et[ut];Xe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut+1,0,0,Te,ye,Gt.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ut+1,Se,Te,ye,Gt.image[Pe])}}}C(w)&&w.mipmapsAutoUpdate===!0&&T(i.TEXTURE_CUBE_MAP),xe.__version=oe.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Ut(P,w,X,he,oe,xe){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),se=E(X.internalFormat,be,te,X.normalized,X.colorSpace),pe=n.get(w),O=n.get(X);if(O.__renderTarget=w,!pe.__hasExternalTextures){let re=Math.max(1,w.width>>xe),ne=Math.max(1,w.height>>xe);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ne,w.depth,0,be,te,null):t.texImage2D(oe,xe,se,re,ne,0,be,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),Me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,oe,O.__webglTexture,0,ct(w)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,oe,O.__webglTexture,xe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Dn(P,w,X){if(i.bindRenderbuffer(i.RENDERBUFFER,P),w.depthBuffer){let he=w.depthTexture,oe=he&&he.isDepthTexture?he.type:null,xe=v(w.stencilBuffer,oe),be=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Me(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(w),xe,w.width,w.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(w),xe,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,xe,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,P)}else{let he=w.textures;for(let oe=0;oe<he.length;oe++){let xe=he[oe],be=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=E(xe.internalFormat,be,te,xe.normalized,xe.colorSpace);Me(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(w),se,w.width,w.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(w),se,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,se,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Mt(P,w,X){let he=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(w.depthTexture);oe.__renderTarget=w;let xe=he?w.depthTexture.image[0]:w.depthTexture.image;(!oe.__webglTexture||xe.width!==w.width||xe.height!==w.height)&&(xe.width=w.width,xe.height=w.height,w.depthTexture.needsUpdate=!0),he?_e(w.depthTexture,0):me(w.depthTexture,0);let be=oe.__webglTexture,te=ct(w),se=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,pe=w.depthTexture.format===qs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Vs)Me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else if(w.depthTexture.format===qs)Me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Tn(P){let w=n.get(P),X=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let he=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),he){let oe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,he.removeEventListener("dispose",oe)};he.addEventListener("dispose",oe),w.__depthDisposeCallback=oe}w.__boundDepthTexture=he}if(P.depthTexture&&!w.__autoAllocateDepthBuffer)if(X)for(let he=0;he<6;he++)Mt(w.__webglFramebuffer[he],P,he);else P.texture.mipmaps.length>0?Mt(w.__webglFramebuffer[0],P,0):Mt(w.__webglFramebuffer,P,0);else if(X){w.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[he]),w.__webglDepthbuffer[he]===void 0)w.__webglDepthbuffer[he]=i.createRenderbuffer(),Dn(w.__webglDepthbuffer[he],P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=w.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Dn(w.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,xe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function sn(P,w,X){let he=n.get(P);w!==void 0&&Ut(he.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&Tn(P)}function pn(P){let w=P.texture,X=n.get(P),he=n.get(w);P.addEventListener("dispose",W),z(P);let oe=P.textures,xe=P.isWebGLCubeRenderTarget===!0,be=oe.length>1;if(be||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=w.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(w.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let se=0;se<w.mipmaps.length;se++)X.__webglFramebuffer[te][se]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(w.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<w.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(be)for(let te=0,se=oe.length;te<se;te++){let pe=n.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Me(P)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=E(se.internalFormat,pe,O,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=ct(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Dn(X.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xe){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),ot(i.TEXTURE_CUBE_MAP,w);for(let te=0;te<6;te++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ut(X.__webglFramebuffer[te][se],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ut(X.__webglFramebuffer[te],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(w)?T(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],O=n.get(pe),re=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ot(re,pe),Ut(X.__webglFramebuffer,P,pe,i.COLOR_ATTACHMENT0+te,re,0),C(pe)&&T(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),ot(te,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Ut(X.__webglFramebuffer[se],P,w,i.COLOR_ATTACHMENT0,te,se);else Ut(X.__webglFramebuffer,P,w,i.COLOR_ATTACHMENT0,te,0);C(w)?T(te):w.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Tn(P)}function U(P){let w=P.textures;for(let X=0,he=w.length;X<he;X++){let oe=w[X];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let xe=R(P),be=n.get(oe).__webglTexture;t.bindTexture(xe,be),T(xe),t.unbindTexture()}}}let Re=[];function Ze(P){if(P.samples>0){if(Me(P)===!1){let w=P.textures,X=P.width,he=P.height,oe=i.COLOR_BUFFER_BIT,xe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(P),te=w.length>1;if(te)for(let pe=0;pe<w.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let pe=0;pe<w.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let O=n.get(w[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,X,he,0,0,X,he,oe,i.NEAREST),l===!0&&(Re.length=0,Re.push(i.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Re.push(xe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<w.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,be.__webglColorRenderbuffer[pe]);let O=n.get(w[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let w=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function ct(P){return Math.min(s.maxSamples,P.samples)}function Me(P){let w=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Bt(P){let w=o.render.frame;h.get(P)!==w&&(h.set(P,w),P.update())}function We(P,w){let X=P.colorSpace,he=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==Ka&&X!==Ys&&(wt.getTransfer(X)===Rt?(he!==Ji||oe!==ui)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",X)),w}function Ye(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=ve,this.setTextureCube=_e,this.rebindTextures=sn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Tn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Me,this.dispose=F}function YA(i,e){function t(n,s=Ys){let r,o=wt.getTransfer(s);if(n===ui)return i.UNSIGNED_BYTE;if(n===wh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Sh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ep)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ap)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Mp)return i.BYTE;if(n===Tp)return i.SHORT;if(n===Jo)return i.UNSIGNED_SHORT;if(n===bh)return i.INT;if(n===Ki)return i.UNSIGNED_INT;if(n===Ni)return i.FLOAT;if(n===Zi)return i.HALF_FLOAT;if(n===Cp)return i.ALPHA;if(n===Pp)return i.RGB;if(n===Ji)return i.RGBA;if(n===Vs)return i.DEPTH_COMPONENT;if(n===qs)return i.DEPTH_STENCIL;if(n===Mh)return i.RED;if(n===Th)return i.RED_INTEGER;if(n===yr)return i.RG;if(n===Eh)return i.RG_INTEGER;if(n===Ah)return i.RGBA_INTEGER;if(n===vl||n===yl||n===xl||n===bl)if(o===Rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===vl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===vl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===yl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===xl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===bl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ch||n===Ph||n===Rh||n===Lh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ch)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ph)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Rh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Lh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Ih||n===kh||n===Dh||n===Nh||n===Oh||n===wl||n===Uh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Ih||n===kh)return o===Rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Dh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Nh)return r.COMPRESSED_R11_EAC;if(n===Oh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===wl)return r.COMPRESSED_RG11_EAC;if(n===Uh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Fh||n===Bh||n===zh||n===Vh||n===Hh||n===Gh||n===Wh||n===Xh||n===$h||n===qh||n===Yh||n===Kh||n===Zh||n===Jh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Fh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Bh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===zh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Vh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Hh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Gh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Wh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Xh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===$h)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===qh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Yh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Kh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Zh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Jh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===jh||n===Qh||n===eu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===jh)return o===Rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Qh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===eu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===tu||n===nu||n===Sl||n===iu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===tu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===nu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Sl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===iu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Gr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var KA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ZA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,nm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ll(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ys({vertexShader:KA,fragmentShader:ZA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new nn(new vs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},im=class extends qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new nm,m={},b=t.getContextAttributes(),C=null,T=null,R=[],E=[],v=new tt,A=null,z=null,N=new ni;N.viewport=new jt;let D=new ni;D.viewport=new jt;let W=[N,D],G=new mh,I=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new Xo,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new Xo,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new Xo,R[ee]=me),me.getHandSpace()};function $(ee){let me=E.indexOf(ee.inputSource);if(me===-1)return;let ge=R[me];ge!==void 0&&(ge.update(ee.inputSource,ee.frame,c||o),ge.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let me=E[ee];me!==null&&(E[ee]=null,R[ee].disconnect(me))}I=null,F=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,T=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(v.width,v.height,!1),z!==null){let ee=z.camera;ee.fov=z.fov,ee.zoom=z.zoom,ee.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",V),s.addEventListener("inputsourceschange",le),b.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,ve=null,_e=null;b.depth&&(_e=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=b.stencil?qs:Vs,ve=b.stencil?Gr:Ki);let Ge={colorFormat:t.RGBA8,depthFormat:_e,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ge),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),T=new wi(d.textureWidth,d.textureHeight,{format:Ji,type:ui,depthTexture:new Xs(d.textureWidth,d.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),T=new wi(f.framebufferWidth,f.framebufferHeight,{format:Ji,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ge=ee.removed[me],ve=E.indexOf(ge);ve>=0&&(E[ve]=null,R[ve].disconnect(ge))}for(let me=0;me<ee.added.length;me++){let ge=ee.added[me],ve=E.indexOf(ge);if(ve===-1){for(let Ge=0;Ge<R.length;Ge++)if(Ge>=E.length){E.push(ge),ve=Ge;break}else if(E[Ge]===null){E[Ge]=ge,ve=Ge;break}if(ve===-1)break}let _e=R[ve];_e&&_e.connect(ge)}}function Z(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ge=ee.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(ge=p.depthFar)),G.near=D.near=N.near=me,G.far=D.far=N.far=ge,(I!==G.near||F!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),I=G.near,F=G.far),G.layers.mask=ee.layers.mask|6,N.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let ve=ee.parent,_e=G.cameras;Z(G,ve);for(let Ge=0;Ge<_e.length;Ge++)Z(_e[Ge],ve);G.projectionMatrix.copy(N.projectionMatrix),G.projectionMatrixInverse.copy(N.projectionMatrixInverse),z===null&&ee.isPerspectiveCamera&&(z={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,G,ve)};function Q(ee,me,ge){ge===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ge.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Go*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let ge=h.views;f!==null&&(e.setRenderTargetFramebuffer(T,f.framebuffer),e.setRenderTarget(T));let ve=!1;ge.length!==G.cameras.length&&(G.cameras.length=0,ve=!0);for(let Ue=0;Ue<ge.length;Ue++){let ot=ge[Ue],ht=null;if(f!==null)ht=f.getViewport(ot);else{let Zt=u.getViewSubImage(d,ot);ht=Zt.viewport,Ue===0&&(e.setRenderTargetTextures(T,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(T))}let at=W[Ue];at===void 0&&(at=new ni,at.layers.enable(Ue),at.viewport=new jt,W[Ue]=at),at.matrix.fromArray(ot.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(ot.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(ht.x,ht.y,ht.width,ht.height),Ue===0&&(G.matrix.copy(at.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),ve===!0&&G.cameras.push(at)}let _e=s.enabledFeatures;if(_e&&_e.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ue=u.getDepthInformation(ge[0]);Ue&&Ue.isValid&&Ue.texture&&p.init(Ue,s.renderState)}if(_e&&_e.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ue=0;Ue<ge.length;Ue++){let ot=ge[Ue].camera;if(ot){let ht=m[ot];ht||(ht=new ll,m[ot]=ht);let at=u.getCameraImage(ot);ht.sourceTexture=at}}}}for(let ge=0;ge<R.length;ge++){let ve=E[ge],_e=R[ge];ve!==null&&_e!==void 0&&_e.update(ve,me,c||o)}ie&&ie(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new cv;ue.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},JA=new Lt,yv=new st;yv.set(-1,0,0,0,1,0,0,0,1);function jA(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,Bp(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,b,C,T){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,T)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,b,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ri&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ri&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let b=e.get(m),C=b.envMap,T=b.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(JA.makeRotationFromEuler(T)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(yv),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,b,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*b,p.scale.value=C*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,b){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ri&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=b.texture,p.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let b=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(b.matrixWorld),p.nearDistance.value=b.shadow.camera.near,p.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function QA(i,e,t,n){let s={},r={};function o(b,C){let T=C.program;n.uniformBlockBinding(b,T,s[b.id])}function a(b,C){let T=s[b.id];T===void 0&&(g(b),T=l(b),s[b.id]=T,b.addEventListener("dispose",p));let R=C.program;n.updateUBOMapping(b,R);let E=e.render.frame;r[b.id]!==E&&(c(b),r[b.id]=E)}function l(b){let C=i.createBuffer(),T=b.__size,R=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,T,R),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(b){let C=s[b.id],T=b.uniforms,R=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let E=0,v=T.length;E<v;E++){let A=T[E];if(Array.isArray(A))for(let z=0,N=A.length;z<N;z++)h(A[z],E,z,R);else h(A,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(b,C,T,R){if(d(b,C,T,R)===!0){let E=b.__offset,v=b.value;if(Array.isArray(v)){let A=0;for(let z=0;z<v.length;z++){let N=v[z],D=y(N,!0);u(N,b.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,b.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,b.__data)}}function u(b,C,T){typeof b=="number"||typeof b=="boolean"?C[T]=b:b.isMatrix3?(C[T]=b.elements[0],C[T+1]=b.elements[1],C[T+2]=b.elements[2],C[T+3]=0,C[T+4]=b.elements[3],C[T+5]=b.elements[4],C[T+6]=b.elements[5],C[T+7]=0,C[T+8]=b.elements[6],C[T+9]=b.elements[7],C[T+10]=b.elements[8],C[T+11]=0):ArrayBuffer.isView(b)?C.set(b.subarray(0,C.length-T),T):b.toArray(C,T)}function d(b,C,T,R){let E=b.value,v=C+"_"+T;if(Array.isArray(E)){R[v]===void 0&&(R[v]=[]);let A=R[v],z=!1;for(let N=0;N<E.length;N++)f(E[N],A,N)===!0&&(z=!0);return z}return f(E,R,v)}function f(b,C,T){if(C[T]===void 0)return typeof b=="number"||typeof b=="boolean"?C[T]=b:ArrayBuffer.isView(b)?C[T]=b.slice():C[T]=b.clone(),!0;{let R=C[T];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return C[T]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function g(b){let C=b.uniforms,T=0,R=16;for(let v=0,A=C.length;v<A;v++){let z=Array.isArray(C[v])?C[v]:[C[v]];for(let N=0,D=z.length;N<D;N++){let W=z[N],G=Array.isArray(W.value)?W.value:[W.value],I=Array.isArray(C[v])||Array.isArray(W.value),F=T;for(let V=0,le=G.length;V<le;V++){let Z=G[V],Q=y(Z,I),ie=T%R,de=ie%Q.boundary,ue=ie+de;T+=de,ue!==0&&R-ue<Q.storage&&(T+=R-ue),V===0&&(F=T),T+=Q.storage}let $=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new $((T-F)/Float32Array.BYTES_PER_ELEMENT),W.__offset=F}}let E=T%R;return E>0&&(T+=R-E),b.__size=T,b.__cache={},this}function y(b,C){let T={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(T.boundary=4,T.storage=4):b.isVector2?(T.boundary=8,T.storage=8):b.isVector3||b.isColor?(T.boundary=16,T.storage=12):b.isVector4?(T.boundary=16,T.storage=16):b.isMatrix3?(T.boundary=16,T.storage=48):b.isMatrix4?(T.boundary=16,T.storage=64):b.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(T.boundary=16,T.storage=b.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",b),C===!0&&(T.boundary=16,T.storage=Math.ceil(T.storage/16)*16),T}function p(b){let C=b.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let b in s)i.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:m}}var eC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),bs=null;function tC(){return bs===null&&(bs=new Nr(eC,16,16,yr,Zi),bs.name="DFG_LUT",bs.minFilter=ii,bs.magFilter=ii,bs.wrapS=ms,bs.wrapT=ms,bs.generateMipmaps=!1,bs.needsUpdate=!0),bs}var lu=class{constructor(e={}){let{canvas:t=I_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ui}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Ah,Eh,Th]),m=new Set([ui,Ki,Jo,Gr,wh,Sh]),b=new Uint32Array(4),C=new Int32Array(4),T={textures:[],min:[],max:[],resolution:[]},R=null,E=null,v=[],A=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,W=null,G=null,I=null,F=null;this._outputColorSpace=ti;let $=0,V=0,le=null,Z=-1,Q=null,ie=new jt,de=new jt,ue=null,ee=new ft(0),me=0,ge=t.width,ve=t.height,_e=1,Ge=null,Je=null,Ue=new jt(0,0,ge,ve),ot=new jt(0,0,ge,ve),ht=!1,at=new ur,Zt=new jc,Ht=!1,fn=!1,Ut=new Lt,Dn=new q,Mt=new jt,Tn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function pn(){return le===null?_e:1}let U=n;function Re(M,B){return t.getContext(M,B)}let Ze,ct,Me,Bt,We,Ye,P,w,X,he,oe,xe,be,te,se,pe,O,re,ne,Te,ye,Se,Xe;try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),U===null){let B="webgl2";if(U=Re(B,M),U===null)throw Re(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(M){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),it("WebGLRenderer: "+M.message),M}function Qe(){Ze=new dE(U),Ze.init(),ye=new YA(U,Ze),ct=new tE(U,Ze,e,ye),Me=new $A(U,Ze),ct.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),G=U.createFramebuffer(),I=U.createFramebuffer(),F=U.createFramebuffer(),Bt=new mE(U),We=new IA,Ye=new qA(U,Ze,Me,We,ct,ye,Bt),P=new uE(N),w=new _M(U),Se=new QT(U,w),X=new fE(U,w,Bt,Se),he=new _E(U,X,w,Se,Bt),re=new gE(U,ct,Ye),se=new nE(We),oe=new LA(N,P,Ze,ct,Se,se),xe=new jA(N,We),be=new DA,te=new zA(Ze),O=new jT(N,P,Me,he,g,l),pe=new XA(N,he,ct),Xe=new QA(U,Bt,ct,Me),ne=new eE(U,Ze,Bt),Te=new pE(U,Ze,Bt),Bt.programs=oe.programs,N.capabilities=ct,N.extensions=Ze,N.properties=We,N.renderLists=be,N.shadowMap=pe,N.state=Me,N.info=Bt}y!==ui&&(z=new yE(y,t.width,t.height,a,s,r));let ce=new im(N,U);this.xr=ce,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let M=Ze.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=Ze.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return _e},this.setPixelRatio=function(M){M!==void 0&&(_e=M,this.setSize(ge,ve,!1))},this.getSize=function(M){return M.set(ge,ve)},this.setSize=function(M,B,j=!0){if(ce.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=M,ve=B,t.width=Math.floor(M*_e),t.height=Math.floor(B*_e),j===!0&&(t.style.width=M+"px",t.style.height=B+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,M,B)},this.getDrawingBufferSize=function(M){return M.set(ge*_e,ve*_e).floor()},this.setDrawingBufferSize=function(M,B,j){ge=M,ve=B,_e=j,t.width=Math.floor(M*j),t.height=Math.floor(B*j),this.setViewport(0,0,M,B)},this.setEffects=function(M){if(y===ui){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let B=0;B<M.length;B++)if(M[B].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(ie)},this.getViewport=function(M){return M.copy(Ue)},this.setViewport=function(M,B,j,Y){M.isVector4?Ue.set(M.x,M.y,M.z,M.w):Ue.set(M,B,j,Y),Me.viewport(ie.copy(Ue).multiplyScalar(pn()).round())},this.getScissor=function(M){return M.copy(ot)},this.setScissor=function(M,B,j,Y){M.isVector4?ot.set(M.x,M.y,M.z,M.w):ot.set(M,B,j,Y),Me.scissor(de.copy(ot).multiplyScalar(pn()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(M){Me.setScissorTest(ht=M)},this.setOpaqueSort=function(M){Ge=M},this.setTransparentSort=function(M){Je=M},this.getClearColor=function(M){return M.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(M=!0,B=!0,j=!0){let Y=0;if(M){let K=!1;if(le!==null){let Ee=le.texture.format;K=p.has(Ee)}if(K){let Ee=le.texture.type,Le=m.has(Ee),Ae=O.getClearColor(),Ie=O.getClearAlpha(),He=Ae.r,nt=Ae.g,_t=Ae.b;Le?(b[0]=He,b[1]=nt,b[2]=_t,b[3]=Ie,U.clearBufferuiv(U.COLOR,0,b)):(C[0]=He,C[1]=nt,C[2]=_t,C[3]=Ie,U.clearBufferiv(U.COLOR,0,C))}else Y|=U.COLOR_BUFFER_BIT}B&&(Y|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&U.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),W=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),be.dispose(),te.dispose(),Ye.dispose(),We.dispose(),P.dispose(),he.dispose(),X.dispose(),Se.dispose(),Xe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",oc),ce.removeEventListener("sessionend",as),Ps.stop()};function Be(M){M.preventDefault(),Dp("WebGLRenderer: Context Lost."),D=!0}function et(){Dp("WebGLRenderer: Context Restored."),D=!1;let M=Bt.autoReset,B=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,K=pe.type;Qe(),Bt.autoReset=M,pe.enabled=B,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=K}function Pe(M){it("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ut(M){let B=M.target;B.removeEventListener("dispose",ut),Gt(B)}function Gt(M){Zn(M),We.remove(M)}function Zn(M){let B=We.get(M).programs;B!==void 0&&(B.forEach(function(j){oe.releaseProgram(j)}),M.isShaderMaterial&&oe.releaseShaderCache(M))}this.renderBufferDirect=function(M,B,j,Y,K,Ee){B===null&&(B=Tn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=Da(M,B,j,Y,K);Me.setMaterial(Y,Le);let Ie=j.index,He=1;if(Y.wireframe===!0){if(Ie=X.getWireframeAttribute(j),Ie===void 0)return;He=2}let nt=j.drawRange,_t=j.attributes.position,ze=nt.start*He,vt=(nt.start+nt.count)*He;Ee!==null&&(ze=Math.max(ze,Ee.start*He),vt=Math.min(vt,(Ee.start+Ee.count)*He)),Ie!==null?(ze=Math.max(ze,0),vt=Math.min(vt,Ie.count)):_t!=null&&(ze=Math.max(ze,0),vt=Math.min(vt,_t.count));let tn=vt-ze;if(tn<0||tn===1/0)return;Se.setup(K,Y,Ae,j,Ie);let kt,Dt=ne;if(Ie!==null&&(kt=w.get(Ie),Dt=Te,Dt.setIndex(kt)),K.isMesh)Y.wireframe===!0?(Me.setLineWidth(Y.wireframeLinewidth*pn()),Dt.setMode(U.LINES)):Dt.setMode(U.TRIANGLES);else if(K.isLine){let En=Y.linewidth;En===void 0&&(En=1),Me.setLineWidth(En*pn()),K.isLineSegments?Dt.setMode(U.LINES):K.isLineLoop?Dt.setMode(U.LINE_LOOP):Dt.setMode(U.LINE_STRIP)}else K.isPoints?Dt.setMode(U.POINTS):K.isSprite&&Dt.setMode(U.TRIANGLES);if(K.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Dt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let En=K._multiDrawStarts,Oe=K._multiDrawCounts,mn=K._multiDrawCount,bt=Ie?w.get(Ie).bytesPerElement:1,Ls=We.get(Y).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)Ls.setValue(U,"_gl_DrawID",gn),Dt.render(En[gn]/bt,Oe[gn])}else if(K.isInstancedMesh)Dt.renderInstances(ze,tn,K.count);else if(j.isInstancedBufferGeometry){let En=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,En);Dt.renderInstances(ze,tn,Oe)}else Dt.render(ze,tn)};function La(M,B,j,Y){W!==null&&M.isNodeMaterial&&W.setObject(Y,M),Ht===!0&&se.setState(M,j,!1),M.transparent===!0&&M.side===hi&&M.forceSinglePass===!1?(M.side=ri,M.needsUpdate=!0,ls(M,B,Y),M.side=vr,M.needsUpdate=!0,ls(M,B,Y),M.side=hi):ls(M,B,Y)}this.compile=function(M,B,j=null){j===null&&(j=M),W!==null&&W.renderStart(M,B,j),E=te.get(j),E.init(B),A.push(E),j.traverseVisible(function(K){K.isLight&&K.layers.test(B.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),M!==j&&M.traverseVisible(function(K){K.isLight&&K.layers.test(B.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),E.setupLights(),W!==null&&W.updateLights(E.state.lightsArray),fn=this.localClippingEnabled,Ht=se.init(this.clippingPlanes,fn),Ht===!0&&se.setGlobalState(this.clippingPlanes,B),W!==null&&pe.render(E.state.shadowsArray,j,B);let Y=new Set;return M.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Le=0;Le<Ee.length;Le++){let Ae=Ee[Le];La(Ae,j,B,K),Y.add(Ae)}else La(Ee,j,B,K),Y.add(Ee)}),E=A.pop(),W!==null&&W.renderEnd(),Y},this.compileAsync=function(M,B,j=null){let Y=this.compile(M,B,j);return new Promise(K=>{function Ee(){if(Y.forEach(function(Le){let Ie=We.get(Le).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Le)}),Y.size===0){K(M);return}setTimeout(Ee,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let fo=null;function Tf(M){fo&&fo(M)}function oc(){Ps.stop()}function as(){Ps.start()}let Ps=new cv;Ps.setAnimationLoop(Tf),typeof self<"u"&&Ps.setContext(self),this.setAnimationLoop=function(M){fo=M,ce.setAnimationLoop(M),M===null?Ps.stop():Ps.start()},ce.addEventListener("sessionstart",oc),ce.addEventListener("sessionend",as),this.render=function(M,B){if(B!==void 0&&B.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;W!==null&&W.renderStart(M,B);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=z!==null&&(le===null||j)&&z.begin(N,le);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(B),B=ce.getCamera()),M.isScene===!0&&M.onBeforeRender(N,M,B,le),E=te.get(M,A.length),E.init(B),E.state.textureUnits=Ye.getTextureUnits(),A.push(E),Ut.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Zt.setFromArrayCamera(B):at.setFromProjectionMatrix(Ut,ki,B.reversedDepth),fn=this.localClippingEnabled,Ht=se.init(this.clippingPlanes,fn),R=be.get(M,v.length),R.init(),v.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=N.xr.getDepthSensingMesh();Le!==null&&Rs(Le,B,-1/0,N.sortObjects)}Rs(M,B,0,N.sortObjects),R.finish(),W!==null&&W.updateLights(E.state.lightsArray),N.sortObjects===!0&&R.sort(Ge,Je),sn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,sn&&O.addToRenderList(R,M),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&se.beginShadows();let K=E.state.shadowsArray;if(pe.render(K,M,B),Ht===!0&&se.endShadows(),(Y&&z.hasRenderPass())===!1){let Le=R.opaque,Ae=R.transmissive;if(E.setupLights(),B.isArrayCamera){let Ie=B.cameras;if(Ae.length>0)for(let He=0,nt=Ie.length;He<nt;He++){let _t=Ie[He];Vi(Le,Ae,M,_t)}sn&&O.render(M);for(let He=0,nt=Ie.length;He<nt;He++){let _t=Ie[He];Ia(R,M,_t,_t.viewport)}}else Ae.length>0&&Vi(Le,Ae,M,B),sn&&O.render(M),Ia(R,M,B)}le!==null&&V===0&&(Ye.updateMultisampleRenderTarget(le),Ye.updateRenderTargetMipmap(le)),Y&&z.end(N),M.isScene===!0&&M.onAfterRender(N,M,B),Se.resetDefaultState(),Z=-1,Q=null,A.pop(),A.length>0?(E=A[A.length-1],Ye.setTextureUnits(E.state.textureUnits),Ht===!0&&se.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,W!==null&&W.renderEnd()};function Rs(M,B,j,Y){if(M.visible===!1)return;if(M.layers.test(B.layers)){if(M.isGroup)j=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(B);else if(M.isLight)E.pushLight(M),M.castShadow&&E.pushShadow(M);else if(M.isSprite){let Le=B.isArrayCamera?Zt:at;if(!M.frustumCulled||M.intersectsFrustum(Le)){Y&&Mt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Ut);let Ae=he.update(M),Ie=M.material;Ie.visible&&R.push(M,Ae,Ie,j,Mt.z,null,B)}}else if(M.isMesh||M.isLine||M.isPoints){let Le=B.isArrayCamera?Zt:at;if(!M.frustumCulled||M.intersectsFrustum(Le)){let Ae=he.update(M),Ie=M.material;if(Y&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Mt.copy(M.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),Mt.copy(Ae.boundingSphere.center)),Mt.applyMatrix4(M.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ie)){let He=Ae.groups;for(let nt=0,_t=He.length;nt<_t;nt++){let ze=He[nt],vt=Ie[ze.materialIndex];vt&&vt.visible&&R.push(M,Ae,vt,j,Mt.z,ze,B)}}else Ie.visible&&R.push(M,Ae,Ie,j,Mt.z,null,B)}}}let Ee=M.children;for(let Le=0,Ae=Ee.length;Le<Ae;Le++)Rs(Ee[Le],B,j,Y)}function Ia(M,B,j,Y){let{opaque:K,transmissive:Ee,transparent:Le}=M;E.setupLightsView(j),Ht===!0&&se.setGlobalState(N.clippingPlanes,j),Y&&Me.viewport(ie.copy(Y)),K.length>0&&rn(K,B,j),Ee.length>0&&rn(Ee,B,j),Le.length>0&&rn(Le,B,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Vi(M,B,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let ze=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new wi(1,1,{generateMipmaps:!0,type:ze?Zi:ui,minFilter:$s,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:wt.workingColorSpace})}let Ee=E.state.transmissionRenderTarget[Y.id],Le=Y.viewport||ie;Ee.setSize(Le.z*N.transmissionResolutionScale,Le.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Ie=N.getActiveCubeFace(),He=N.getActiveMipmapLevel();N.setRenderTarget(Ee),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),sn&&O.render(j);let nt=N.toneMapping;N.toneMapping=xs;let _t=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),Ht===!0&&se.setGlobalState(N.clippingPlanes,Y),rn(M,j,Y),Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let vt=0,tn=B.length;vt<tn;vt++){let kt=B[vt],{object:Dt,geometry:En,material:Oe,group:mn}=kt;if(Oe.side===hi&&Dt.layers.test(Y.layers)){let bt=Oe.side;Oe.side=ri,Oe.needsUpdate=!0,hn(Dt,j,Y,En,Oe,mn),Oe.side=bt,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee))}N.setRenderTarget(Ae,Ie,He),N.setClearColor(ee,me),_t!==void 0&&(Y.viewport=_t),N.toneMapping=nt}function rn(M,B,j){let Y=B.isScene===!0?B.overrideMaterial:null;for(let K=0,Ee=M.length;K<Ee;K++){let Le=M[K],{object:Ae,geometry:Ie,group:He}=Le,nt=Le.material;nt.allowOverride===!0&&Y!==null&&(nt=Y),Ae.layers.test(j.layers)&&hn(Ae,B,j,Ie,nt,He)}}function hn(M,B,j,Y,K,Ee){W!==null&&K.isNodeMaterial&&W.setObject(M,K),M.onBeforeRender(N,B,j,Y,K,Ee),M.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),K.onBeforeRender(N,B,j,Y,M,Ee),K.transparent===!0&&K.side===hi&&K.forceSinglePass===!1?(K.side=ri,K.needsUpdate=!0,N.renderBufferDirect(j,B,Y,K,M,Ee),K.side=vr,K.needsUpdate=!0,N.renderBufferDirect(j,B,Y,K,M,Ee),K.side=hi):N.renderBufferDirect(j,B,Y,K,M,Ee),M.onAfterRender(N,B,j,Y,K,Ee)}function un(M){let B=0;for(let j of M)j.texture!==null&&B++;return B}function ls(M,B,j){B.isScene!==!0&&(B=Tn);let Y=We.get(M),K=E.state.lights,Ee=E.state.shadowsArray,Le=K.state.version,Ae=oe.getParameters(M,K.state,Ee,B,j,E.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ae),He=Y.programs;Y.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let nt=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;Y.envMap=P.get(M.envMap||Y.environment,nt),Y.envMapRotation=Y.environment!==null&&M.envMap===null?B.environmentRotation:M.envMapRotation,He===void 0&&(M.addEventListener("dispose",ut),He=new Map,Y.programs=He,Y.programVariants=new Map);let _t=He.get(Ie);if(_t!==void 0){if(Y.currentProgram===_t&&Y.lightsStateVersion===Le)return ka(M,Ae),_t}else Ae.uniforms=oe.getUniforms(M),W!==null&&M.isNodeMaterial&&W.build(M,j,Ae),M.onBeforeCompile(Ae,N),_t=oe.acquireProgram(Ae,Ie),He.set(Ie,_t),Y.uniforms=Ae.uniforms;let ze=Y.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(ze.clippingPlanes=se.uniform),ka(M,Ae),Y.needsLights=er(M),Y.lightsStateVersion=Le,Y.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=un(E.state.lightProbeGridArray),Y.currentProgram=_t,Y.uniformsList=null,_t}function mi(M,B,j,Y,K){let Ee=We.get(M),Le=Ee.currentProgram.id+","+Y+","+K,Ae=Ee.programVariants.get(Le);return Ae===void 0?(Ae=ls(M,B,j),Ee.programVariants.set(Le,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=K),Ae}function Qs(M){if(M.uniformsList===null){let B=M.currentProgram.getUniforms();M.uniformsList=Qo.seqWithValue(B.seq,M.uniforms)}return M.uniformsList}function ka(M,B){let j=We.get(M);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function Da(M,B,j,Y,K){B.isScene!==!0&&(B=Tn),Ye.resetTextureUnits();let Ee=B.fog,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:wt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,He=P.get(Y.envMap||Le,Ie),nt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,_t=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!j.morphAttributes.position,vt=!!j.morphAttributes.normal,tn=!!j.morphAttributes.color,kt=xs;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(kt=N.toneMapping);let Dt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,En=Dt!==void 0?Dt.length:0,Oe=We.get(Y),mn=E.state.lights;if(Ht===!0&&(fn===!0||M!==Q)){let Nt=M===Q&&Y.id===Z;se.setState(Y,M,Nt)}let bt=!1,Ls=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==mn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==He||Y.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==se.numPlanes||Oe.numIntersection!==se.numIntersection)||Oe.vertexAlphas!==nt||Oe.vertexTangents!==_t||Oe.morphTargets!==ze||Oe.morphNormals!==vt||Oe.morphColors!==tn||Oe.morphTargetsCount!==En||Oe.numLightProbeGrids!==un(E.state.lightProbeGridArray)?bt=!0:(Oe.outputColorSpace!==Ae||Oe.toneMapping!==kt)&&(Ls=!0):(bt=!0,Oe.__version=Y.version);let gn=Oe.currentProgram;(bt===!0||Ls===!0)&&(gn=Ls===!0?mi(Y,B,K,Ae,kt):ls(Y,B,K),W&&Y.isNodeMaterial&&W.onUpdateProgram(Y,gn,Oe));let go=!1,cs=!1,Is=!1,pt=gn.getUniforms(),on=Oe.uniforms;if(Me.useProgram(gn.program)&&(go=!0,cs=!0,Is=!0),Y.id!==Z&&(Z=Y.id,cs=!0),go||Q!==M){Me.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),pt.setValue(U,"projectionMatrix",M.projectionMatrix),pt.setValue(U,"viewMatrix",M.matrixWorldInverse);let _n=pt.map.cameraPosition;_n!==void 0&&_n.setValue(U,Dn.setFromMatrixPosition(M.matrixWorld)),ct.logarithmicDepthBuffer&&pt.setValue(U,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&pt.setValue(U,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,cs=!0,Is=!0)}if(Oe.needsLights&&(mn.state.sunShadowMap.length>0&&pt.setValue(U,"sunShadowMap",mn.state.sunShadowMap,Ye),mn.state.directionalShadowMap.length>0&&pt.setValue(U,"directionalShadowMap",mn.state.directionalShadowMap,Ye),mn.state.spotShadowMap.length>0&&pt.setValue(U,"spotShadowMap",mn.state.spotShadowMap,Ye),mn.state.pointShadowMap.length>0&&pt.setValue(U,"pointShadowMap",mn.state.pointShadowMap,Ye)),K.isSkinnedMesh){pt.setOptional(U,K,"bindMatrix"),pt.setOptional(U,K,"bindMatrixInverse");let Nt=K.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),pt.setValue(U,"boneTexture",Nt.boneTexture,Ye))}K.isBatchedMesh&&(pt.setOptional(U,K,"batchingTexture"),pt.setValue(U,"batchingTexture",K._matricesTexture,Ye),pt.setOptional(U,K,"batchingIdTexture"),pt.setValue(U,"batchingIdTexture",K._indirectTexture,Ye),pt.setOptional(U,K,"batchingColorTexture"),K._colorsTexture!==null&&pt.setValue(U,"batchingColorTexture",K._colorsTexture,Ye));let Jn=j.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&re.update(K,j,gn),(cs||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,pt.setValue(U,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(on.envMapIntensity.value=B.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=tC()),cs){if(pt.setValue(U,"toneMappingExposure",N.toneMappingExposure),Oe.needsLights&&po(on,Is),Ee&&Y.fog===!0&&xe.refreshFogUniforms(on,Ee),xe.refreshMaterialUniforms(on,Y,_e,ve,E.state.transmissionRenderTarget[M.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Nt=T,_n=0;for(let $n of E.state.lightProbeGridArray)$n.texture!==null&&(Nt.textures[_n]=$n.texture,Nt.min[_n]=$n.boundingBox.min,Nt.max[_n]=$n.boundingBox.max,Nt.resolution[_n]=$n.resolution,_n++);for(let $n in Nt)Nt[$n].length=_n;on.probesSH.value=Nt.textures,on.probesMin.value=Nt.min,on.probesMax.value=Nt.max,on.probesResolution.value=Nt.resolution}Qo.upload(U,Qs(Oe),on,Ye)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Qo.upload(U,Qs(Oe),on,Ye),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&pt.setValue(U,"center",K.center),pt.setValue(U,"modelViewMatrix",K.modelViewMatrix),pt.setValue(U,"normalMatrix",K.normalMatrix),pt.setValue(U,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Nt=Y.uniformsGroups;for(let _n=0,$n=Nt.length;_n<$n;_n++){let ac=Nt[_n];Xe.update(ac,gn),Xe.bind(ac,gn)}}return gn}function po(M,B){M.ambientLightColor.needsUpdate=B,M.lightProbe.needsUpdate=B,M.sunLights.needsUpdate=B,M.sunLightShadows.needsUpdate=B,M.directionalLights.needsUpdate=B,M.directionalLightShadows.needsUpdate=B,M.pointLights.needsUpdate=B,M.pointLightShadows.needsUpdate=B,M.spotLights.needsUpdate=B,M.spotLightShadows.needsUpdate=B,M.rectAreaLights.needsUpdate=B,M.hemisphereLights.needsUpdate=B}function er(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(M,B,j){let Y=We.get(M);Y.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),We.get(M.texture).__webglTexture=B,We.get(M.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,B){let j=We.get(M);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(M,B=0,j=0){le=M,$=B,V=j;let Y=null,K=!1,Ee=!1;if(M){let Ae=We.get(M);if(Ae.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(U.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(M.viewport),de.copy(M.scissor),ue=M.scissorTest,Me.viewport(ie),Me.scissor(de),Me.setScissorTest(ue),Z=-1;return}else if(Ae.__webglFramebuffer===void 0)Ye.setupRenderTarget(M);else if(Ae.__hasExternalTextures)Ye.rebindTextures(M,We.get(M.texture).__webglTexture,We.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let nt=M.depthTexture;if(Ae.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(M.width!==nt.image.width||M.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(M)}}let Ie=M.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let He=We.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(He[B])?Y=He[B][j]:Y=He[B],K=!0):M.samples>0&&Ye.useMultisampledRTT(M)===!1?Y=We.get(M).__webglMultisampledFramebuffer:Array.isArray(He)?Y=He[j]:Y=He,ie.copy(M.viewport),de.copy(M.scissor),ue=M.scissorTest}else ie.copy(Ue).multiplyScalar(_e).floor(),de.copy(ot).multiplyScalar(_e).floor(),ue=ht;if(j!==0&&(Y=G),Me.bindFramebuffer(U.FRAMEBUFFER,Y)&&Me.drawBuffers(M,Y),Me.viewport(ie),Me.scissor(de),Me.setScissorTest(ue),K){let Ae=We.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ae.__webglTexture,j)}else if(Ee){let Ae=B;for(let Ie=0;Ie<M.textures.length;Ie++){let He=We.get(M.textures[Ie]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Ie,He.__webglTexture,j,Ae)}}else if(M!==null&&j!==0){let Ae=We.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ae.__webglTexture,j)}Z=-1};function mo(M){let B=We.get(M);return(B.__readFormat!==M.format||B.__readType!==M.type)&&(B.__readFormat=M.format,B.__readType=M.type,B.__formatReadable=ct.textureFormatReadable(M.format),B.__typeReadable=ct.textureTypeReadable(M.type)),B}this.readRenderTargetPixels=function(M,B,j,Y,K,Ee,Le,Ae=0){if(!(M&&M.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=We.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Le!==void 0&&(Ie=Ie[Le],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(U.FRAMEBUFFER,Ie);try{let He=M.textures[Ae],nt=He.format,_t=He.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let ze=mo(He);if(ze.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-K&&U.readPixels(B,j,Y,K,ye.convert(nt),ye.convert(_t),Ee)}finally{let He=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(M,B,j,Y,K,Ee,Le,Ae=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=We.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Le!==void 0&&(Ie=Ie[Le],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-K){Me.bindFramebuffer(U.FRAMEBUFFER,Ie);let He=M.textures[Ae],nt=He.format,_t=He.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let ze=mo(He);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,vt),U.bufferData(U.PIXEL_PACK_BUFFER,Ee.byteLength,U.STREAM_READ),U.readPixels(B,j,Y,K,ye.convert(nt),ye.convert(_t),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let tn=le!==null?We.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,tn);let kt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await D_(U,kt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,vt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Ee),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(vt),U.deleteSync(kt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,B=null,j=0){let Y=Math.pow(2,-j),K=Math.floor(M.image.width*Y),Ee=Math.floor(M.image.height*Y),Le=B!==null?B.x:0,Ae=B!==null?B.y:0;Ye.setTexture2D(M,0),U.copyTexSubImage2D(U.TEXTURE_2D,j,0,0,Le,Ae,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(M,B,j=null,Y=null,K=0,Ee=0){let Le,Ae,Ie,He,nt,_t,ze,vt,tn,kt=M.isCompressedTexture?M.mipmaps[Ee]:M.image;if(j!==null)Le=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,He=j.min.x,nt=j.min.y,_t=j.isBox3?j.min.z:0;else{let pt=Math.pow(2,-K);Le=Math.floor(kt.width*pt),Ae=Math.floor(kt.height*pt),M.isDataArrayTexture?Ie=kt.depth:M.isData3DTexture?Ie=Math.floor(kt.depth*pt):Ie=1,He=0,nt=0,_t=0}Y!==null?(ze=Y.x,vt=Y.y,tn=Y.z):(ze=0,vt=0,tn=0);let Dt=ye.convert(B.format),En=ye.convert(B.type),Oe;B.isData3DTexture?(Ye.setTexture3D(B,0),Oe=U.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Ye.setTexture2DArray(B,0),Oe=U.TEXTURE_2D_ARRAY):(Ye.setTexture2D(B,0),Oe=U.TEXTURE_2D),Me.activeTexture(U.TEXTURE0),Me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,B.flipY),Me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Me.pixelStorei(U.UNPACK_ALIGNMENT,B.unpackAlignment);let mn=Me.getParameter(U.UNPACK_ROW_LENGTH),bt=Me.getParameter(U.UNPACK_IMAGE_HEIGHT),Ls=Me.getParameter(U.UNPACK_SKIP_PIXELS),gn=Me.getParameter(U.UNPACK_SKIP_ROWS),go=Me.getParameter(U.UNPACK_SKIP_IMAGES);Me.pixelStorei(U.UNPACK_ROW_LENGTH,kt.width),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,kt.height),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,He),Me.pixelStorei(U.UNPACK_SKIP_ROWS,nt),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,_t);let cs=M.isDataArrayTexture||M.isData3DTexture,Is=B.isDataArrayTexture||B.isData3DTexture;if(M.isDepthTexture){let pt=We.get(M),on=We.get(B),Jn=We.get(pt.__renderTarget),Nt=We.get(on.__renderTarget);Me.bindFramebuffer(U.READ_FRAMEBUFFER,Jn.__webglFramebuffer),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let _n=0;_n<Ie;_n++)cs&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,We.get(M).__webglTexture,K,_t+_n),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,We.get(B).__webglTexture,Ee,tn+_n)),U.blitFramebuffer(He,nt,He+Le,nt+Ae,ze,vt,ze+Le,vt+Ae,U.DEPTH_BUFFER_BIT,U.NEAREST);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(K!==0||M.isRenderTargetTexture||We.has(M)){let pt=We.get(M),on=We.get(B);Me.bindFramebuffer(U.READ_FRAMEBUFFER,I),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,F);for(let Jn=0;Jn<Ie;Jn++)cs?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,pt.__webglTexture,K,_t+Jn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,pt.__webglTexture,K),Is?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,on.__webglTexture,Ee,tn+Jn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,on.__webglTexture,Ee),K!==0?U.blitFramebuffer(He,nt,He+Le,nt+Ae,ze,vt,ze+Le,vt+Ae,U.COLOR_BUFFER_BIT,U.NEAREST):Is?U.copyTexSubImage3D(Oe,Ee,ze,vt,tn+Jn,He,nt,Le,Ae):U.copyTexSubImage2D(Oe,Ee,ze,vt,He,nt,Le,Ae);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Is?M.isDataTexture||M.isData3DTexture?U.texSubImage3D(Oe,Ee,ze,vt,tn,Le,Ae,Ie,Dt,En,kt.data):B.isCompressedArrayTexture?U.compressedTexSubImage3D(Oe,Ee,ze,vt,tn,Le,Ae,Ie,Dt,kt.data):U.texSubImage3D(Oe,Ee,ze,vt,tn,Le,Ae,Ie,Dt,En,kt):M.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Ee,ze,vt,Le,Ae,Dt,En,kt.data):M.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Ee,ze,vt,kt.width,kt.height,Dt,kt.data):U.texSubImage2D(U.TEXTURE_2D,Ee,ze,vt,Le,Ae,Dt,En,kt);Me.pixelStorei(U.UNPACK_ROW_LENGTH,mn),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,bt),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,Ls),Me.pixelStorei(U.UNPACK_SKIP_ROWS,gn),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,go),Ee===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&U.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(M){We.get(M).__webglFramebuffer===void 0&&Ye.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Ye.setTextureCube(M,0):M.isData3DTexture?Ye.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Ye.setTexture2DArray(M,0):Ye.setTexture2D(M,0),Me.unbindTexture()},this.resetState=function(){$=0,V=0,le=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=wt._getDrawingBufferColorSpace(e),t.unpackColorSpace=wt._getUnpackColorSpace()}};function sm(i){let e=i.height_m/Math.tan(i.up_rad),t=i.height_m/Math.tan(i.down_rad),n=(e+i.top_m+t)/2;return[{x:-n,y:0},{x:n,y:0},{x:n-t,y:i.height_m},{x:-n+e,y:i.height_m}]}function wv(i){let e=i.depth_m/2;return[{x:-e,y:0},{x:e,y:0},{x:e,y:i.height_m},{x:-e,y:i.height_m}]}function uu(i,e,t=12){let n=[];for(let[s,r]of[[i/2,-Math.PI/2],[-i/2,Math.PI/2]])for(let o=0;o<=t;o++){let a=r+Math.PI*o/t;n.push({x:s+e*Math.cos(a),y:e+e*Math.sin(a)})}return n}function ta(i,e){return 2*i+2*Math.PI*e}function du(i,e,t){let n=ta(i,e),s=Math.PI*e,r=(t%n+n)%n;return r<i/2?{x:r,y:0,outward_rad:-Math.PI/2}:(r-=i/2,r<s?xv(i/2,e,-Math.PI/2+r/e):(r-=s,r<i?{x:i/2-r,y:2*e,outward_rad:Math.PI/2}:(r-=i,r<s?xv(-i/2,e,Math.PI/2+r/e):{x:-i/2+r-s,y:0,outward_rad:-Math.PI/2})))}function xv(i,e,t){return{x:i+e*Math.cos(t),y:e+e*Math.sin(t),outward_rad:t}}function Sv(i,e){let t=i.length,n=[],s=-e/2,r=e/2,o=(...a)=>{for(let[l,c]of a){let h=i[l%t]??{x:0,y:0};n.push(h.x,c,h.y)}};for(let a=0;a<t;a++)o([a,s],[a+1,r],[a+1,s]),o([a,s],[a,r],[a+1,r]);for(let a=1;a<t-1;a++)o([0,s],[a,s],[a+1,s]),o([0,r],[a+1,r],[a,r]);return new Float32Array(n)}function bv(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad),r=e-i.x_m,o=t-i.y_m;return{x:n*r+s*o,y:-s*r+n*o}}function Ks(i,e,t){let n=Math.cos(i.heading_rad),s=Math.sin(i.heading_rad);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([r=0,o=0])=>{let a=r*e/2,l=o*t/2;return{x:i.x_m+n*a-s*l,y:i.y_m+s*a+n*l}})}function na(i){return 2*(sm(i)[1]?.x??0)}function nC(i,e,t){let n=0;for(let s of i.ramps){let r=bv(s,e,t),o=na(s)/2;if(Math.abs(r.y)>s.width_m/2||Math.abs(r.x)>=o)continue;let a=Math.min((r.x+o)*Math.tan(s.up_rad),(o-r.x)*Math.tan(s.down_rad));n=Math.max(n,Math.min(a,s.height_m))}for(let s of i.blocks){let r=bv(s,e,t);Math.abs(r.y)<=s.width_m/2&&Math.abs(r.x)<=s.depth_m/2&&(n=Math.max(n,s.height_m))}return n}function Mv(i,e=.005){let t=[];return i.path.forEach((n,s)=>{let r=i.path[s-1],o=r===void 0?1:Math.ceil(Math.hypot(n.x_m-r.x_m,n.y_m-r.y_m)/e);for(let a=1;a<=o;a++){let l=r===void 0?n.x_m:r.x_m+(n.x_m-r.x_m)*a/o,c=r===void 0?n.y_m:r.y_m+(n.y_m-r.y_m)*a/o;t.push(l,c,nC(i,l,c))}}),new Float32Array(t)}function Cl(i){let e=i?.fence;if(!e)return[];if(e.corners!==void 0)return e.corners.map(({x_m:o,y_m:a})=>({x:o,y:a}));let{min_x_m:t,max_x_m:n,min_y_m:s,max_y_m:r}=e;return[{x:t,y:s},{x:n,y:s},{x:n,y:r},{x:t,y:r}]}function fu(i){return(i?.keep_out??[]).map(({corners:e})=>e.map(({x_m:t,y_m:n})=>({x:t,y:n})))}function xr(i){let e={min_x:1/0,max_x:-1/0,min_y:1/0,max_y:-1/0},t=(n,s)=>{e.min_x=Math.min(e.min_x,n),e.max_x=Math.max(e.max_x,n),e.min_y=Math.min(e.min_y,s),e.max_y=Math.max(e.max_y,s)};for(let n of i?.path??[])t(n.x_m,n.y_m);for(let n of i?.ramps??[])for(let{x:s,y:r}of Ks(n,na(n),n.width_m))t(s,r);for(let n of i?.blocks??[])for(let{x:s,y:r}of Ks(n,n.depth_m,n.width_m))t(s,r);for(let{x:n,y:s}of Cl(i))t(n,s);return e.min_x>e.max_x?{min_x:-1,max_x:1,min_y:-.6,max_y:.6}:e}function Tv(i,e,t,n,s,r){let o=i.length/3;for(let a=e;a<t;a++){let l=3*Math.max(a-1,0),c=3*Math.min(a+1,o-1),h=3*a,u=(i[c]??0)-(i[l]??0),d=(i[c+1]??0)-(i[l+1]??0),f=Math.hypot(u,d)||1;u*=n/2/f,d*=n/2/f;let g=i[h]??0,y=i[h+1]??0,p=(i[h+2]??0)+s;r.set([g-d,y+u,p,g+d,y-u,p],6*a)}}function rm(i,e){let t=new An;return t.setAttribute("position",new Vn(Sv(i,e),3)),t.computeVertexNormals(),t}function Xr(i,e,t,n){let s=rm(i,e),r=new nn(s,new Yi({color:t}));return r.castShadow=!0,r.receiveShadow=!0,n!==void 0&&r.add(new _s(new Fr(s,20),new Si({color:n}))),r}function ia([i,e,t],[n,s,r],o){let a=Xr([{x:-n/2,y:-r/2},{x:n/2,y:-r/2},{x:n/2,y:r/2},{x:-n/2,y:r/2}],s,o);return a.position.set(i,e,t),a}function Pl(i){i.traverse(e=>{if(!(e instanceof nn||e instanceof Or))return;e.geometry.dispose();let t=e.material;for(let n of Array.isArray(t)?t:[t])n.map?.dispose(),n.dispose()}),i.clear()}var Ev=48,iC=.004,$r={name:"",length_m:.185,width_m:.2,height_m:.06,gauge_m:.155,axle_spacing_m:.133,wheel_radius_m:.026,shoe_width_m:.045},Av=.012,Cv=["000000","011010","001110","010010","011100","000000"],Rl=class{constructor(e){this.shape=e;let{axle_spacing_m:t,wheel_radius_m:n,shoe_width_m:s,gauge_m:r}=e,o=uu(t,n-.002),a=this.track(r/2,o),l=this.track(-r/2,o);this.cleats=[a,l];let c=r-s,h=e.height_m-.012;this.group.add(ia([0,0,(.016+h)/2],[t+n*.9,c-.006,h-.016],"#2b333d"),ia([0,0,h],[t+n*1.2,c+.01,.003],"#c9d1da"),ia([-.02,0,h+.004],[.075,.05,.003],"#0f7f86"),ia([-.054,.012,h+.008],[.014,.012,.01],"#aab3bd"),ia([t/2+n*.62,0,h-.008],[.006,c*.7,.006],"#fff3c4"),sC(e.height_m)),this.group.rotation.order="ZYX"}shape;group=new Di;cleats;set(e,t,n){Lv(this.group,e),this.run(this.cleats[0],t),this.run(this.cleats[1],n)}track(e,t){let{axle_spacing_m:n,wheel_radius_m:s,shoe_width_m:r}=this.shape,o=Xr(t,r,"#1b2026");o.position.y=e,this.group.add(o);for(let c of[-n/2,n/2]){let h=Xr(uu(0,s-.007,10),r+.002,"#8b96a3");h.position.set(c,e,.007),this.group.add(h)}let a=Math.round(ta(n,s)/Av),l=new rl(new dr(Av*.5,r+.001,.0035),new Yi({color:"#4a545f"}),a);return l.position.y=e,l.castShadow=!0,l.frustumCulled=!1,this.group.add(l),l}run(e,t){let{axle_spacing_m:n,wheel_radius_m:s}=this.shape,r=ta(n,s);for(let o=0;o<e.count;o++){let a=du(n,s-.002,o*r/e.count-t);Pv.setFromAxisAngle(rC,Math.PI/2-a.outward_rad),Rv.compose(aC.set(a.x,0,a.y+5e-4),Pv,oC),e.setMatrixAt(o,Rv)}e.instanceMatrix.needsUpdate=!0}},pu=class{line;constructor(e){let t=Array.from({length:Ev},(n,s)=>{let r=2*Math.PI*s/Ev;return new q(Math.cos(r),Math.sin(r),0)});this.line=new Ur(new An().setFromPoints(t),new Si({color:e}))}set({x_m:e,y_m:t,z_m:n,sd_x_m:s,sd_y_m:r}){let o=typeof s=="number"&&typeof r=="number";this.line.visible=o,o&&(this.line.position.set(e,t,n+iC),this.line.scale.set(2*s,2*r,1))}},mu=class{group=new Di;constructor(e,t){let n=uu(e.axle_spacing_m,e.wheel_radius_m,6),s=rm(n,e.shoe_width_m),r=new Fr(s,40);s.dispose();for(let o of[-1,1]){let a=new _s(r,new Si({color:t,transparent:!0,opacity:.9}));a.position.y=o*e.gauge_m/2,this.group.add(a)}this.group.rotation.order="ZYX"}set(e){Lv(this.group,e)}};function Lv(i,e){i.position.set(e.x_m,e.y_m,e.z_m),i.rotation.set(e.roll_rad,e.pitch_rad,e.yaw_rad,"ZYX")}function sC(i){let e=Cv.length+2,t=new Uint8Array(4*e*e).fill(255);Cv.forEach((r,o)=>{for(let a=0;a<r.length;a++){let l=4*((o+1)*e+a+1);r[a]==="0"&&t.fill(16,l,l+3)}});let n=new Nr(t,e,e);n.colorSpace=ti,n.magFilter=xn,n.needsUpdate=!0;let s=new nn(new vs(.05,.05),new Yi({map:n}));return s.position.set(.045,0,i),s}var rC=new q(0,1,0),oC=new q(1,1,1),aC=new q,Pv=new si,Rv=new Lt;function Iv(i){return/^\s*\[(model|shape|drive|emulated)\b/m.test(i)&&!/^\s*\[\[segment\]\]/m.test(i)?"robot":"course"}function sa(i){return i.replace(/\.toml$/i,"").replace(/[^A-Za-z0-9._-]+/g,"-").replace(/^[.-]+/,"").slice(0,64)}function Ll(i){let e=(t,n)=>t===void 0||t===0?[]:[`${t} ${n}${t===1?"":"s"}`];return i.length_m===void 0?"":[`${i.length_m.toFixed(2)} m`,...i.duration_s===void 0?[]:[`${i.duration_s.toFixed(0)} s`],...e(i.ramps?.length,"ramp"),...e(i.blocks?.length,"block"),...e(i.surfaces?.length,"surface"),...e(i.disturbances,"disturbance")].join(" · ")}var uy=vS(ly(),1),la=class{constructor(e){this.text=e;let[t]=(0,uy.parseTOML)(e,{tomlVersion:"1.0.0"}).body;this.take([],t.body.filter(n=>n.type==="TOMLKeyValue"),void 0);for(let n of t.body)n.type==="TOMLTable"&&this.take(n.resolvedKey,n.body,n.range)}text;pieces_=new Map;all(e){return this.pieces_.get(e)??[]}one(e){return this.pieces_.get(e)?.[0]??{table:e,index:0,values:{},ranges:{},range:void 0}}with(e,t){let n=[],s=[];for(let[r,o]of Object.entries(t)){let a=e.ranges[r];a===void 0?n.push(bm(r,o)):bP(e.values[r],o)||s.push({from:a[0],to:a[1],text:Fl(o)})}return n.length>0&&s.push(this.inserted(e,n)),s.sort((r,o)=>o.from-r.from),s.reduce((r,{from:o,to:a,text:l})=>r.slice(0,o)+l+r.slice(a),this.text)}added(e,t,n=this.all(e).at(-1)){let s=hy(`[[${e}]]`,t);if(n!==void 0&&n.range===void 0)throw Uu(n);let r=this.one("fence").range,o=n?.range!==void 0?this.lineEnd(n.range[1]):r===void 0?this.text.length:this.above(r[0]);return cy(this.text.slice(0,o),s,this.text.slice(o))}addedBefore(e,t,n){let s=this.all(e)[t]?.range;if(s===void 0)return this.added(e,n);let r=this.above(s[0]);return cy(this.text.slice(0,r),hy(`[[${e}]]`,n),this.text.slice(r))}replaced(e,t,n){let s=t.flatMap(a=>e.ranges[a]?.[0]??[]).map(a=>this.text.lastIndexOf(`
`,a)+1),r=Math.min(...s);if(!Number.isFinite(r)||e.range===void 0)throw Uu(e);let o=this.text;for(let a of s.sort((l,c)=>c-l))o=o.slice(0,a)+o.slice(this.lineEnd(a));return o.slice(0,r)+Object.entries(n).map(([a,l])=>bm(a,l)).join("")+o.slice(r)}removed(e){if(e.range===void 0)throw Uu(e);let t=this.above(e.range[0]),n=this.lineEnd(e.range[1]);for(;this.text[n]===`
`||this.text.startsWith(`\r
`,n);)n+=this.text[n]===`
`?1:2;return this.text.slice(0,t)+this.text.slice(n)}take(e,t,n){let s={},r={},o=[];for(let a of t){let l=a.key.keys.map(c=>c.type==="TOMLBare"?c.name:c.value);if(a.value.type==="TOMLInlineTable")o.push([[...e,...l],a.value.body]);else if(a.value.type==="TOMLArray"&&a.value.elements[0]?.type==="TOMLInlineTable")a.value.elements.forEach((c,h)=>{c.type==="TOMLInlineTable"&&o.push([[...e,...l,h],c.body])});else{let c=dy(a.value);if(c===void 0)continue;let[h,u]=e.length===0&&l.length===2?[l[0],l[1]]:[void 0,l.join(".")];if(u===void 0)continue;h===void 0?(s[u]=c,r[u]=a.value.range):o.push([[h],[{...a,key:{...a.key,keys:a.key.keys.slice(1)}}]])}}this.add(String(e[0]??""),s,r,n);for(let[a,l]of o)this.take(a,l,void 0)}add(e,t,n,s){let r=this.pieces_.get(e)??[];r.push({table:e,index:r.length,values:t,ranges:n,range:s}),this.pieces_.set(e,r)}inserted(e,t){if((e.table==="start"||e.table==="fence")&&Object.keys(e.values).length===0&&e.range===void 0){let a=this.above(this.all("segment")[0]?.range?.[0]??this.text.length);return{from:a,to:a,text:`[${e.table}]
${t.join("")}
`}}if(e.range===void 0&&e.table!=="")throw Uu(e);let s=Math.max(e.range?.[1]??0,...Object.values(e.ranges).map(([,a])=>a)),r=s===0?0:this.lineEnd(s),o=r>0&&this.text[r-1]!==`
`?`
${t.join("")}`:t.join("");return{from:r,to:r,text:o}}above(e){let t=this.text.lastIndexOf(`
`,e-1)+1;for(;;){let n=this.text.lastIndexOf(`
`,t-2)+1;if(t===0||!/^[ \t]*#/.test(this.text.slice(n,t)))return t;t=n}}lineEnd(e){let t=this.text.indexOf(`
`,e);return t<0?this.text.length:t+1}};function cy(i,e,t){let n=i===""||/\n\s*\n$/.test(i)?"":i.endsWith(`
`)?`
`:`

`,s=t===""||/^\r?\n/.test(t)?"":`
`;return i+n+e+s+t}function Uu(i){return new Error(`${i.table} is not written as a table of its own: change it in the text`)}function dy(i){if(i.type==="TOMLArray")return i.elements.map(dy).filter(e=>e!==void 0);if(i.type==="TOMLValue")return typeof i.value=="object"?void 0:i.value}function bP(i,e){return i!==void 0&&Fl(i)===Fl(e)}function hy(i,e){return`${i}
${Object.entries(e).map(([t,n])=>bm(t,n)).join("")}`}function bm(i,e){return`${i} = ${Fl(e)}
`}function Fl(i){if(Array.isArray(i))return`[${i.map(Fl).join(", ")}]`;if(typeof i!="number")return JSON.stringify(i);let e=String(Number(i.toFixed(3))+0);return e.includes(".")?e:`${e}.0`}var Oi=Math.PI/180,wP=.02,SP=3*Oi;function en(i,e,t=0){let n=i.values[e];return typeof n=="number"&&Number.isFinite(n)?n:t}function Bl(i){return{x:en(i,"x_m"),y:en(i,"y_m"),yaw_rad:en(i,"yaw_deg")*Oi,s_m:0}}function py(i){let e=en(i,"angle_deg")*Oi;return i.values.type==="line"?{length_m:en(i,"length_m"),angle_rad:0}:i.values.type==="arc"?{length_m:en(i,"radius_m")*Math.abs(e),angle_rad:e}:{length_m:0,angle_rad:e}}function Kr(i,e,t=1){let{length_m:n,angle_rad:s}=py(e),[r,o]=[t*n,t*s],a=i.yaw_rad+o,l=i.s_m+r;if(o===0||r===0)return{x:i.x+r*Math.cos(i.yaw_rad),y:i.y+r*Math.sin(i.yaw_rad),yaw_rad:a,s_m:l};let c=r/o;return{x:i.x+c*(Math.sin(a)-Math.sin(i.yaw_rad)),y:i.y-c*(Math.cos(a)-Math.cos(i.yaw_rad)),yaw_rad:a,s_m:l}}function wm(i,e){let t=[i];for(let n of e)t.push(Kr(t.at(-1)??i,n));return t}function Sm(i,e){let t=[fy(i)],n=i;for(let s of e){let{length_m:r,angle_rad:o}=py(s),a=Math.min(Math.max(Math.ceil(r/wP),Math.ceil(Math.abs(o)/SP),1),2e3);for(let l=1;l<=a;l++)t.push(fy(Kr(n,s,l/a)));n=Kr(n,s)}return t}function fy({x:i,y:e,yaw_rad:t,s_m:n}){return{x_m:i,y_m:e,yaw_rad:t,s_m:n}}function Mm(i,e){let t=Math.cos(i.yaw_rad)*(e.x-i.x)+Math.sin(i.yaw_rad)*(e.y-i.y);return Math.max(t,.01)}function Tm(i,e){let[t,n]=[e.x-i.x,e.y-i.y],s=Math.cos(i.yaw_rad)*t+Math.sin(i.yaw_rad)*n,r=-Math.sin(i.yaw_rad)*t+Math.cos(i.yaw_rad)*n,o=Math.hypot(s,r),a=r<0?-1:1,l=Math.min(o*o/Math.max(2*Math.abs(r),1e-6),100),c=2*Math.atan2(Math.abs(r),s)/Oi;return{radius_m:Math.max(l,.01),angle_deg:a*Math.max(c,.1)}}function Em(i,e){let t,n=1/0;for(let s of i){let r=Math.hypot(s.x_m-e.x,s.y_m-e.y);r<n&&([t,n]=[s,r])}return t}function my(i,e){return i.find(t=>t.s_m>=e-1e-9)??i.at(-1)}var gy=.15,vy=`description = "drawn on the page"
speed_mps = 0.1

[[segment]]
type = "line"
length_m = 0.6

[fence]
min_x_m = -0.3
max_x_m = 1.6
min_y_m = -0.8
max_y_m = 0.8
`,ca={segment:{},ramp:{heading_deg:0,height_m:.05,up_deg:15,top_m:.2,down_deg:15,width_m:.4},block:{heading_deg:0,height_m:.02,depth_m:.1,width_m:.4},surface:{name:"other ground",heading_deg:0,length_m:.3,width_m:.5,friction_factor:1,slip_offset:0},disturbance:{at_m:0,sideways_m:.03,yaw_deg:0,duration_s:.3},keep_out:{}};function zl(i,{table:e,index:t}){return e==="start"||e==="fence"||e===""?i.one(e):i.all(e)[t]}function Fu(i){return{x_m:en(i,"x_m"),y_m:en(i,"y_m"),heading_rad:en(i,"heading_deg")*Oi}}function Zr(i){let e=i.values.corners_m;if(!Array.isArray(e))return;let t=e.map(n=>Array.isArray(n)?{x:Number(n[0]),y:Number(n[1])}:{x:NaN,y:NaN});return t.length>0&&t.every(({x:n,y:s})=>Number.isFinite(n+s))?t:void 0}var yy=i=>i.map(({x:e,y:t})=>[e,t]);function Cm(i){let e=Zr(i);if(e!==void 0)return e;let[t,n,s,r]=["min_x_m","max_x_m","min_y_m","max_y_m"].map(o=>en(i,o,NaN));if(Number.isFinite(t+n+s+r))return[{x:t,y:s},{x:n,y:s},{x:n,y:r},{x:t,y:r}]}var _y=({x:i,y:e})=>({x_m:i,y_m:e});function Pm(i,e,t){let n=Bl(i.one("start")),s=Sm(n,i.all("segment")),r=Cm(i.one("fence")),o=(r??[]).map(({x:l})=>l),a=(r??[]).map(({y:l})=>l);return{name:e,description:"",speed_mps:en(i.one(""),"speed_mps",.1),length_m:s.at(-1)?.s_m??0,start:{x_m:n.x,y_m:n.y,yaw_rad:n.yaw_rad},path:s,ramps:i.all("ramp").map(l=>({...Fu(l),height_m:en(l,"height_m"),up_rad:en(l,"up_deg",15)*Oi,top_m:en(l,"top_m"),down_rad:en(l,"down_deg",15)*Oi,width_m:en(l,"width_m")})),blocks:i.all("block").map(l=>({...Fu(l),height_m:en(l,"height_m"),depth_m:en(l,"depth_m"),width_m:en(l,"width_m")})),surfaces:i.all("surface").map(l=>({...Fu(l),name:String(l.values.name??""),length_m:en(l,"length_m"),width_m:en(l,"width_m")})),disturbances:[],...r===void 0?{}:{fence:{min_x_m:Math.min(...o),max_x_m:Math.max(...o),min_y_m:Math.min(...a),max_y_m:Math.max(...a),corners:r.map(_y)}},keep_out:i.all("keep_out").map(l=>({corners:(Zr(l)??[]).map(_y)})),robot:t}}function xy(i){return[...MP(i),...TP(i),...EP(i),...AP(i)]}function MP(i){let e=i.one("start"),t=Bl(e),n=i.all("segment"),s=wm(t,n),r=[wr("start","Start",e,t,({x:o,y:a})=>i.with(e,{x_m:o,y_m:a})),Am("start-turn","Direction of the start",e,t,t.yaw_rad,o=>i.with(e,{yaw_deg:o/Oi}))];return n.forEach((o,a)=>{let l=s[a]??t,c=`segment-${a}`,h=`End of ${String(o.values.type)} ${a+1}`;if(o.values.type==="line")r.push(wr(c,h,o,Kr(l,o),u=>i.with(o,{length_m:Mm(l,u)})));else if(o.values.type==="arc")r.push(wr(c,h,o,Kr(l,o),u=>i.with(o,{...Tm(l,u)})));else if(o.values.type==="pivot"){let u=d=>i.with(o,{angle_deg:by(d-l.yaw_rad)});r.push(Am(c,h,o,l,Kr(l,o).yaw_rad,u))}}),r}function TP(i){return["ramp","block","surface"].flatMap(e=>i.all(e).flatMap(t=>{let{x_m:n,y_m:s,heading_rad:r}=Fu(t),o=`${e}-${t.index}`,a=`${e} ${t.index+1}`;return[wr(o,a,t,{x:n,y:s},l=>i.with(t,{x_m:l.x,y_m:l.y})),Am(`${o}-turn`,`Direction of ${a}`,t,{x:n,y:s},r,l=>i.with(t,{heading_deg:l/Oi}))]}))}function EP(i){let e=wy(i);return i.all("disturbance").flatMap(t=>{let n=my(e,en(t,"at_m"));if(n===void 0)return[];let s=r=>i.with(t,{at_m:Em(e,r)?.s_m??0});return[wr(`disturbance-${t.index}`,`disturbance ${t.index+1}`,t,{x:n.x_m,y:n.y_m},s)]})}function AP(i){let e=i.one("fence"),t=[],n=(r,o,a)=>{o.forEach((l,c)=>{let h=u=>i.with(r,{corners_m:yy(o.map((d,f)=>f===c?u:d))});t.push(wr(`${r.table}-${r.index}-${c}`,`Corner ${c+1} of ${a}`,r,l,h))})},s=Zr(e);if(s!==void 0)n(e,s,"the fence");else{let r=[["min_x_m","min_y_m"],["max_x_m","min_y_m"],["max_x_m","max_y_m"],["min_x_m","max_y_m"]];(Cm(e)??[]).forEach((o,a)=>{let[l,c]=r[a]??r[0];t.push(wr(`fence-0-${a}`,`Corner ${a+1} of the fence`,e,o,h=>i.with(e,{[l]:h.x,[c]:h.y})))})}for(let r of i.all("keep_out"))n(r,Zr(r)??[],`keep-out area ${r.index+1}`);return t}function wr(i,e,t,{x:n,y:s},r){return{id:i,label:e,turns:!1,at:{x:n,y:s},piece:{table:t.table,index:t.index},drag:r}}function Am(i,e,t,n,s,r){let o={x:n.x+gy*Math.cos(s),y:n.y+gy*Math.sin(s)};return{...wr(i,e,t,o,a=>r(Math.atan2(a.y-n.y,a.x-n.x))),turns:!0}}function by(i){let e=i-2*Math.PI*Math.round(i/(2*Math.PI));return Math.max(Math.abs(e/Oi),1)*(e<0?-1:1)}function wy(i){return Sm(Bl(i.one("start")),i.all("segment"))}function Sy(i){let e=My(i);return{x:e.x+.3*Math.cos(e.yaw_rad),y:e.y+.3*Math.sin(e.yaw_rad)}}function My(i){let e=Bl(i.one("start"));return wm(e,i.all("segment")).at(-1)??e}function Ty(i,e,t){let n=My(i),s=u=>({text:i.added("segment",u),piece:{table:"segment",index:i.all("segment").length}});if(e==="line")return s({type:"line",length_m:Mm(n,t)});if(e==="arc")return s({type:"arc",...Tm(n,t)});if(e==="pivot")return s({type:"pivot",angle_deg:by(Math.atan2(t.y-n.y,t.x-n.x)-n.yaw_rad)});let r=i.all(e).length;if(e==="keep_out"){let u=[[-1,-1],[1,-1],[1,1],[-1,1]].map(([d=0,f=0])=>[t.x+.1*d,t.y+.1*f]);return{text:i.added("keep_out",{corners_m:u}),piece:{table:"keep_out",index:r}}}let o=Em(wy(i),t);if(e==="disturbance"){let u=o?.s_m??0,d=i.all("disturbance").filter(f=>en(f,"at_m")<=u);return d.length<r?{text:i.addedBefore("disturbance",d.length,{...ca.disturbance,at_m:u}),piece:{table:e,index:d.length}}:{text:i.added(e,{...ca.disturbance,at_m:u}),piece:{table:e,index:r}}}let a=(o?.yaw_rad??0)/Oi%360,{name:l,...c}=ca[e],h={...l===void 0?{}:{name:l},x_m:t.x,y_m:t.y,...c,heading_deg:a};return{text:i.added(e,h),piece:{table:e,index:r}}}function Ey(i,e,t){let n=e.table==="fence"?Cm(e):Zr(e),[s,r]=[n?.[t],n?.[(t+1)%(n.length||1)]];if(n===void 0||s===void 0||r===void 0)return i.text;let o={x:(s.x+r.x)/2,y:(s.y+r.y)/2};return Cy(i,e,[...n.slice(0,t+1),o,...n.slice(t+1)])}function Ay(i,e,t){let n=Zr(e);return n===void 0||n.length<=3?i.text:Cy(i,e,n.filter((s,r)=>r!==t))}function Cy(i,e,t){let n={corners_m:yy(t)};return Zr(e)===void 0?i.replaced(e,["min_x_m","max_x_m","min_y_m","max_y_m"],n):i.with(e,n)}var CP={...ca,"":{description:"",speed_mps:.1},start:{x_m:0,y_m:0,yaw_deg:0}},PP={"":"course",keep_out:"keep-out area"};function Py(i,e){let t=i.table in ca,n=`${PP[i.table]??i.table}${t?` ${i.index+1}`:""}`,s=x("div",{class:"draw-fields",role:"group","aria-label":n},x("h3",{},n)),r=CP[i.table]??{};for(let o of new Set([...Object.keys(i.values),...Object.keys(r)])){let a=i.values[o]??r[o];if(a===void 0||Array.isArray(a)||typeof a=="boolean"||o==="type")continue;let l=typeof a=="number",c=x("input",{type:l?"number":"text",name:o,step:"any",value:String(a)});c.addEventListener("change",()=>{let h=l?Number(c.value):c.value;c.value!==""&&(!l||Number.isFinite(h))&&e(o,h)}),s.append(x("label",{},`${o} `,c))}return s}function Ry(i,e,t){return JSON.stringify([i.values,e,t?.values])}var Bu=class{texts=[""];at=0;restart(e){this.texts=[e],this.at=0}add(e){e!==this.text&&(this.texts=[...this.texts.slice(0,this.at+1),e].slice(-200),this.at=this.texts.length-1)}get text(){return this.texts[this.at]??""}get canUndo(){return this.at>0}get canRedo(){return this.at+1<this.texts.length}undo(){return this.canUndo&&this.at--,this.text}redo(){return this.canRedo&&this.at++,this.text}};var Rm=.2,Ly=1.2,RP=200;function Iy(i){let e=xr(i),t=Math.max(0,Ly-(e.max_x-e.min_x))/2+Rm,n=Math.max(0,Ly-(e.max_y-e.min_y))/2+Rm;return{min_x:e.min_x-t,max_x:e.max_x+t,min_y:e.min_y-n,max_y:e.max_y+n}}function ky(i,e){let[t,n]=[(i.min_x+i.max_x)/2,(i.min_y+i.max_y)/2],[s,r]=[e*(i.max_x-i.min_x)/2,e*(i.max_y-i.min_y)/2];return Math.max(s,r)>RP/2||Math.min(s,r)<Rm?i:{min_x:t-s,max_x:t+s,min_y:n-r,max_y:n+r}}var Dy=18,LP=.01,IP=.1,Lm="http://www.w3.org/2000/svg",kP={ArrowLeft:{x:-1,y:0},ArrowRight:{x:1,y:0},ArrowUp:{x:0,y:1},ArrowDown:{x:0,y:-1}},zu=class{constructor(e,t,n){this.pixel=e;this.world=t;this.actions=n;this.element.classList.add("draw-stage"),this.element.setAttribute("role","group"),this.element.setAttribute("aria-label","Points of the course"),this.element.style.display="none",this.element.addEventListener("pointerdown",s=>{this.down(s)}),this.element.addEventListener("pointermove",s=>{this.drag(s,!1)});for(let s of["pointerup","pointercancel"])this.element.addEventListener(s,r=>{this.drag(r,!0)});this.element.addEventListener("wheel",s=>{s.preventDefault(),n.zoom(s.deltaY>0?1.1:1/1.1)},{passive:!1})}pixel;world;actions;element=document.createElementNS(Lm,"svg");knobs=new Map;handles=[];dragged;show(e){this.element.style.display=e?"":"none",this.dragged=void 0}get dragging(){return this.dragged!==void 0}draw(e,t){this.handles=e;let n=new Set(this.knobs.keys());for(let s of e){n.delete(s.id);let r=this.knobs.get(s.id)??this.make(s),o=this.pixel(s.at);r.style.display=o===void 0?"none":"",o!==void 0&&$e(r,"transform",`translate(${o.x.toFixed(1)} ${o.y.toFixed(1)})`),$e(r,"aria-label",`${s.label}: x ${s.at.x.toFixed(2)} m, y ${s.at.y.toFixed(2)} m`),$e(r,"data-of",s.piece.table),dt(r,"turns",s.turns),dt(r,"selected",s.piece.table===t?.table&&s.piece.index===t.index)}for(let s of n)this.knobs.get(s)?.remove(),this.knobs.delete(s)}focus(e){this.knobs.get(e)?.focus()}make(e){let{id:t}=e,n=document.createElementNS(Lm,"g");n.classList.add("knob"),n.dataset.handle=t,$e(n,"tabindex","0"),$e(n,"role","button");for(let[s,r]of[[Dy,"knob-reach"],[6,"knob-dot"]]){let o=document.createElementNS(Lm,"circle");o.setAttribute("r",String(s)),o.classList.add(r),n.append(o)}return n.addEventListener("focus",()=>{let s=this.handle(t);s!==void 0&&this.actions.select(s)}),n.addEventListener("keydown",s=>{this.key(s,t)}),this.knobs.set(t,n),this.element.append(n),n}handle(e){return this.handles.find(t=>t.id===e)}key(e,t){let n=this.handle(t),s=kP[e.key];if(!(n===void 0||e.ctrlKey||e.altKey||e.metaKey)){if(s!==void 0){let r=e.shiftKey?IP:LP;this.actions.move(n,{x:n.at.x+r*s.x,y:n.at.y+r*s.y},!0)}else if(e.key==="Delete"||e.key==="Backspace")this.actions.remove(n);else return;e.preventDefault()}}at(e){let t=this.element.getBoundingClientRect();return this.world({x:e.clientX-t.left,y:e.clientY-t.top})}down(e){if(!e.isPrimary||e.button!==0)return;e.preventDefault();let t=this.nearest(e);if(t===void 0){let n=this.at(e);n!==void 0&&this.actions.press(n);return}this.element.setPointerCapture(e.pointerId),this.dragged={id:t,pointer:e.pointerId},this.focus(t)}nearest(e){let t=this.element.getBoundingClientRect(),[n,s]=[void 0,Dy];for(let{id:r,at:o}of this.handles){let a=this.pixel(o);if(a===void 0)continue;let l=Math.hypot(a.x-e.clientX+t.left,a.y-e.clientY+t.top);l<s&&([n,s]=[r,l])}return n}drag(e,t){if(e.pointerId!==this.dragged?.pointer)return;let n=this.handle(this.dragged.id),s=this.at(e);t&&(this.dragged=void 0),n!==void 0&&s!==void 0&&this.actions.move(n,s,t)}};var Ot=i=>i instanceof Error?i.message:String(i),Im=new Map;function Vu(i){let e=Im.get(i)??fetch(`/api/history${i}`).then(t=>t.ok?t.json():[]);return Im.set(i,e),setTimeout(()=>Im.delete(i),1e3),e}var DP=150,NP=[["line","Line"],["arc","Arc"],["pivot","Turn"],["ramp","Ramp"],["block","Block"],["surface","Surface"],["disturbance","Disturbance"],["keep_out","Keep-out"]],Hu=class{constructor(e,t,n,s){this.map=e;this.ask=t;this.robot=n;this.opens=s;this.stage=new zu(r=>e.pixel(r),r=>e.world(r),{select:r=>{this.select(r)},move:(r,o,a)=>{this.edit(()=>r.drag(Ny(o)),a)},press:r=>{this.press(r)},remove:r=>{this.select(r),this.remove()},zoom:r=>{this.zoom(r)}}),this.build()}map;ask;robot;opens;element=x("div",{class:"draw",hidden:""});stage;name=x("input",{type:"text",name:"course-name","aria-label":"Name of the course",maxlength:"64"});text=x("textarea",{rows:"14",spellcheck:"false","aria-label":"Text of the course file"});verdict=x("p",{class:"draw-verdict",role:"status"});fieldsBox=x("div");replaceButton=Ms("draw-replace","Replace it");undoButton=Ms("draw-undo","Undo");redoButton=Ms("draw-redo","Redo");deleteButton=Ms("draw-delete","Delete");cornerButton=Ms("draw-corner","Add corner");closeButton=Ms("draw-close","Close");saves=[Ms("draw-save","Save"),Ms("draw-use","Save and choose")];tools=new Map;history=new Bu;course=new la("");handles_=[];selected;corner;tool;frame;changed=!1;opened="";saved="";shownFields="";checkAt_ms=1/0;checking=!1;chooses=!1;get active(){return!this.element.hidden}open(e,t,n){this.opened=n?e:"",this.saved=t,this.name.value=e,this.element.hidden=!1,this.selected=this.corner=void 0,this.pick(void 0),this.say(""),this.history.restart(t),this.course=new la(""),this.take(t),this.fit(),this.stage.show(!0),this.opens(!0)}openNew(e){let t=1;for(;e.includes(`drawn-${t}`);)t++;this.open(`drawn-${t}`,vy,!1),this.pick("line")}close(){this.element.hidden=!0,this.checkAt_ms=1/0,this.stage.show(!1),this.map.draft(void 0,void 0),this.opens(!1)}tick(e,t){if(!this.active)return;this.changed&&(this.changed=!1,this.map.draft(Pm(this.course,this.name.value,this.robot()??$r),this.frame)),this.stage.draw(this.handles_,this.selected),this.undoButton.disabled=!this.history.canUndo,this.redoButton.disabled=!this.history.canRedo;let n=this.selected&&zl(this.course,this.selected);this.deleteButton.disabled=n===void 0||["start","fence",""].includes(n.table)&&this.corner===void 0,this.cornerButton.disabled=this.corner===void 0;for(let r of this.saves)r.disabled=!t;this.replaceButton.disabled=!t;let s=Ry(this.course.one(""),this.selected,n);s!==this.shownFields&&!this.stage.dragging&&!this.fieldsBox.contains(document.activeElement)&&(this.shownFields=s,this.fieldsBox.replaceChildren(...[this.course.one(""),n].filter(r=>r!==void 0).map(r=>this.fieldsOf(r)))),e>=this.checkAt_ms&&!this.checking&&this.check()}build(){let e=x("div",{class:"draw-bar",role:"toolbar","aria-label":"Draw"});for(let[n,s]of NP){let r=Ms(`draw-${n}`,s);$e(r,"aria-pressed","false"),r.addEventListener("click",o=>{o.detail===0?this.add(n,Sy(this.course)):this.pick(this.tool===n?void 0:n)}),this.tools.set(n,r),e.append(r)}let t=Ms("draw-fit","Fit");e.append(this.cornerButton,this.deleteButton,this.undoButton,this.redoButton,t),t.addEventListener("click",()=>{this.fit()}),this.undoButton.addEventListener("click",()=>{this.take(this.history.undo())}),this.redoButton.addEventListener("click",()=>{this.take(this.history.redo())}),this.deleteButton.addEventListener("click",()=>{this.remove()}),this.cornerButton.addEventListener("click",()=>{let n=this.selected&&zl(this.course,this.selected),s=this.corner;n!==void 0&&s!==void 0&&this.edit(()=>Ey(this.course,n,s),!0)}),this.saves.forEach((n,s)=>{n.addEventListener("click",()=>{this.chooses=s===1,this.save(!1)})}),this.replaceButton.addEventListener("click",()=>{this.save(!0)}),this.closeButton.addEventListener("click",()=>{(this.course.text!==this.saved||this.text.value!==this.course.text)&&this.closeButton.textContent==="Close"?Ce(this.closeButton,"Discard the changes"):this.close()}),this.closeButton.addEventListener("blur",()=>{Ce(this.closeButton,"Close")}),this.text.addEventListener("input",()=>{this.take(this.text.value,!1)}),this.text.addEventListener("change",()=>{this.history.add(this.text.value)}),this.element.addEventListener("keydown",n=>{this.key(n)}),this.stage.element.addEventListener("keydown",n=>{this.key(n)}),this.element.append(e,x("div",{class:"draw-answer"},this.verdict,this.replaceButton),x("div",{class:"draw-file"},x("label",{},"name ",this.name),...this.saves,this.closeButton),this.fieldsBox,x("details",{},x("summary",{},"Text of the file"),this.text))}key(e){if(!(e.ctrlKey||e.metaKey)||e.target===this.text)return;let t=e.key.toLowerCase();t!=="z"&&t!=="y"||(e.preventDefault(),this.take(t==="y"||e.shiftKey?this.history.redo():this.history.undo()))}pick(e){this.tool=e;for(let[t,n]of this.tools)$e(n,"aria-pressed",String(t===e));dt(this.stage.element,"adds",e!==void 0)}press(e){this.tool!==void 0&&(this.add(this.tool,e),this.tool!=="line"&&this.tool!=="arc"&&this.pick(void 0))}add(e,t){this.edit(()=>{let n=Ty(this.course,e,Ny(t));return this.selected=n.piece,this.corner=void 0,n.text},!0)}select(e){this.selected=e.piece;let t=/^(fence|keep_out)-\d+-(\d+)$/.exec(e.id);this.corner=t===null?void 0:Number(t[2])}remove(){let e=this.selected&&zl(this.course,this.selected),t=this.corner;e!==void 0&&(this.edit(()=>{let n=t===void 0?this.course.text:Ay(this.course,e,t);return n!==this.course.text||["start","fence",""].includes(e.table)?n:this.course.removed(e)},!0),this.corner=void 0)}edit(e,t){try{this.take(e()),t&&this.history.add(this.course.text)}catch(n){this.say(Ot(n),!0)}}take(e,t=!0){t&&this.text.value!==e&&(this.text.value=e),this.checkAt_ms=performance.now()+DP;try{this.course=new la(e)}catch{return}this.handles_=xy(this.course),this.changed=!0,this.active&&this.stage.draw(this.handles_,this.selected)}fit(){this.frame=Iy(Pm(this.course,"",$r)),this.changed=!0}zoom(e){this.frame!==void 0&&(this.frame=ky(this.frame,e)),this.changed=!0}fieldsOf(e){let t={table:e.table,index:e.index};return Py(e,(n,s)=>{let r=zl(this.course,t);r!==void 0&&this.edit(()=>this.course.with(r,{[n]:s}),!0)})}async check(){this.checking=!0,this.checkAt_ms=1/0;try{let e=await this.ask({name:"file_check",request:{kind:"course",name:sa(this.name.value)||"course",text:this.text.value}}),t=e.line===void 0?"":`line ${e.line}, column ${e.column??1}: `,n=`${e.length_m?.toFixed(2)??""} m, about ${e.duration_s?.toFixed(0)??"?"} s`;e.error!==""?this.say(t+e.error,!0):e.why_not!==""?this.say(`${e.length_m?.toFixed(2)??""} m; ${e.why_not}`,!0):this.say(n)}catch(e){this.say(Ot(e),!0)}finally{this.checking=!1}}async save(e){let t=this.name.value,n=this.text.value;try{if(await this.ask({name:"file_save",request:{kind:"course",name:t,text:n,replace:e||t===this.opened}}),this.opened=t,this.saved=n,this.say(`${t} is saved.`),!this.chooses)return;await this.ask({name:"choose",request:{course:t}}),this.close()}catch(s){let r=Ot(s);this.say(r,!0),this.replaceButton.hidden=!r.includes("exists already")}}say(e,t=!1){this.replaceButton.hidden=!0,Ce(this.verdict,e),dt(this.verdict,"bad",t)}},Ny=({x:i,y:e})=>({x:Math.round(i*1e3)/1e3,y:Math.round(e*1e3)/1e3});function Ms(i,e){return x("button",{type:"button",id:i,class:"control"},e)}var Oy=40,OP=5,Gu=class{constructor(e,t,n,s,r){this.call=e;this.move=t;this.inputs=n;this.attended=s;this.ended=r}call;move;inputs;attended;ended;share=.5;limits={speed_mps:.2,yaw_rate_radps:1};wish;token;taking=!1;wasDriven=!1;unanswered=0;get drives(){return this.token!==void 0}async take(){if(!(this.drives||this.taking)){this.taking=!0,this.inputs.clear();try{let e=await this.move("drive_take",{});if(typeof e?.token!="string")throw new Error("the daemon gave no token");this.token=e.token,this.wasDriven=!1,this.unanswered=0,this.leave()}catch(e){this.ended(Ot(e))}finally{this.taking=!1}}}release(){let e=this.token;e!==void 0&&(this.forget(),this.call("drive_release",{token:e}).catch(()=>{}),this.ended(""))}lose(e){this.drives&&(this.forget(),this.ended(e))}leave(){this.inputs.clear(),this.drives&&this.send(this.inputs.wish())}received(e){this.drives&&(e.run==="driving"?this.wasDriven=!0:this.wasDriven&&this.lose(e.run==="idle"?"the robot was disarmed":`the drive is over: ${e.run}`))}tick(){!this.drives||!this.attended()||this.send(this.inputs.wish())}send(e){let t=this.token;if(this.wish=e,this.unanswered>=OP)return;++this.unanswered;let n={token:t,speed_mps:e.forward*this.share*this.limits.speed_mps,yaw_rate_radps:e.left*this.share*this.limits.yaw_rate_radps,input_ms:e.at_ms};this.call("drive",n).then(()=>{this.unanswered=Math.max(0,this.unanswered-1)},s=>{t===this.token&&this.lose(Ot(s))})}forget(){this.token=void 0,this.wish=void 0,this.inputs.clear()}};var Dm={ArrowUp:{forward:1,left:0},KeyW:{forward:1,left:0},ArrowDown:{forward:-1,left:0},KeyS:{forward:-1,left:0},ArrowLeft:{forward:0,left:1},KeyA:{forward:0,left:1},ArrowRight:{forward:0,left:-1},KeyD:{forward:0,left:-1}},Uy=1e3,UP=2e3,FP=500,km=.12,BP=.9;function zP(i){return i in Dm}function Wu(i){return Math.max(-1,Math.min(1,i))}function Fy(i){let e=Math.abs(i);return e>km?Math.sign(i)*Math.min(1,(e-km)/(BP-km)):0}var Xu=class{constructor(e,t){this.pads=e;this.now=t}pads;now;frozen=!1;silent=!1;held=new Set;repeats="";spoke_ms=-1/0;stick;padIndex=-1;padValues="";padChanged_ms=-1/0;key(e,t){return this.keys(this.now()),this.spoke_ms=this.now(),t!=="released"?this.repeats=e:this.repeats===e&&(this.repeats=""),zP(e)?(t==="repeated"||(this.silent=!1,t==="pressed"?this.held.add(e):this.held.delete(e)),!0):!1}touch(e){this.stick=e}clear(){this.held.clear(),this.stick=void 0,this.frozen=this.silent=!1,this.padChanged_ms=-1/0}wish(){let e=this.now(),t=this.pad(e);if(this.keys(e),this.stick!==void 0)return{forward:Wu(this.stick.forward),left:Wu(this.stick.left),source:"stick",at_ms:e};if(this.held.size>0){let n=0,s=0;for(let r of this.held)n+=Dm[r]?.forward??0,s+=Dm[r]?.left??0;return{forward:Wu(n),left:Wu(s),source:"keys",at_ms:e}}return t??{forward:0,left:0,source:"none",at_ms:e}}keys(e){if(this.held.size===0)return;let t=e-this.spoke_ms;this.silent=t>Uy,t>(this.repeats===""?UP:Uy)&&this.held.clear()}pad(e){let t=this.pads().find(a=>a?.connected===!0&&a.axes.length>=2),n=t?[...t.axes,...t.buttons.map(({value:a})=>a)].join(" "):"",s=t?.index??-1;if(s!==this.padIndex?this.padChanged_ms=-1/0:n!==this.padValues&&(this.padChanged_ms=e),this.padIndex=s,this.padValues=n,this.frozen=!1,!t)return;let r=Fy(-(t.axes[1]??0)),o=Fy(-(t.axes[0]??0));if(!(r===0&&o===0))return this.frozen=e-this.padChanged_ms>FP,this.frozen?{forward:0,left:0,source:"gamepad",at_ms:e}:{forward:r,left:o,source:"gamepad",at_ms:e}}};var zy=["foxglove.sdk.v1","foxglove.websocket.v1"],Om=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),$u=i=>Number.isSafeInteger(i)&&i>=0,Qi=i=>typeof i=="string"?i:"",Nm=i=>Array.isArray(i)?i.filter(Om):[],By=i=>Array.isArray(i)?i.filter($u):[];function Vy(i){let e;try{e=JSON.parse(i)}catch{return}if(Om(e))switch(e.op){case"serverInfo":return{op:"serverInfo",name:Qi(e.name),sessionId:Qi(e.sessionId),capabilities:Array.isArray(e.capabilities)?e.capabilities.map(Qi):[],metadata:Om(e.metadata)?Object.fromEntries(Object.entries(e.metadata).map(([t,n])=>[t,Qi(n)])):{}};case"advertise":return{op:"advertise",channels:Nm(e.channels).filter(t=>$u(t.id)).map(t=>({id:t.id,topic:Qi(t.topic),encoding:Qi(t.encoding),schemaName:Qi(t.schemaName)}))};case"unadvertise":return{op:"unadvertise",channelIds:By(e.channelIds)};case"advertiseServices":return{op:"advertiseServices",services:Nm(e.services).filter(t=>$u(t.id)).map(t=>({id:t.id,name:Qi(t.name)}))};case"unadvertiseServices":return{op:"unadvertiseServices",serviceIds:By(e.serviceIds)};case"parameterValues":return{op:"parameterValues",parameters:Nm(e.parameters).filter(t=>typeof t.name=="string").map(t=>({name:Qi(t.name),value:t.value})),id:typeof e.id=="string"?e.id:void 0};case"serviceCallFailure":return $u(e.callId)?{op:"serviceCallFailure",callId:e.callId,message:Qi(e.message)}:void 0;case"status":return{op:"status",level:Number(e.level)||0,message:Qi(e.message)};default:return}}function Hy(i){let e=new DataView(i);if(!(e.byteLength<1))switch(e.getUint8(0)){case 1:return e.byteLength<13?void 0:{op:"message",subscriptionId:e.getUint32(1,!0),time_s:Number(e.getBigUint64(5,!0))*1e-9,payload:new Uint8Array(i,13)};case 2:return e.byteLength<9?void 0:{op:"time",time_s:Number(e.getBigUint64(1,!0))*1e-9};case 3:{if(e.byteLength<13)return;let t=e.getUint32(9,!0);return t>e.byteLength-13?void 0:{op:"serviceResponse",serviceId:e.getUint32(1,!0),callId:e.getUint32(5,!0),encoding:new TextDecoder().decode(new Uint8Array(i,13,t)),payload:new Uint8Array(i,13+t)}}default:return}}function Gy(i){return JSON.stringify({op:"subscribe",subscriptions:i})}function Wy(i){return JSON.stringify({op:"unsubscribe",subscriptionIds:i})}function Xy(i,e,t){return JSON.stringify({op:"setParameters",parameters:[{name:i,value:e}],id:t})}function $y(i,e,t){let n=new TextEncoder().encode("json"),s=new TextEncoder().encode(JSON.stringify(t)),r=new ArrayBuffer(13+n.length+s.length),o=new DataView(r);return o.setUint8(0,2),o.setUint32(1,i,!0),o.setUint32(5,e,!0),o.setUint32(9,n.length,!0),new Uint8Array(r,13).set(n),new Uint8Array(r,13+n.length).set(s),r}function Ky(i){let e=new WebSocket(i.replace(/^http/,"ws"),zy);return e.binaryType="arraybuffer",e}var qy=200,HP=2e3,GP=3e3,WP=1e4,Yy=500,qu=class{constructor(e,t,n=()=>performance.now()){this.make=e;this.events=t;this.now=n;this.watched_ms=this.now(),this.watchTimer=setInterval(()=>{this.watch()},Yy),this.open()}make;events;now;socket;isOpen=!1;silent_ms=0;watched_ms=0;retry_ms=qy;retryTimer;watchTimer;get connected(){return this.isOpen}send(e){return!this.isOpen||this.socket===void 0?!1:(this.socket.send(e),!0)}retryNow(){this.retryTimer!==void 0&&(clearTimeout(this.retryTimer),this.open())}end(){clearInterval(this.watchTimer),this.drop(),clearTimeout(this.retryTimer),this.retryTimer=void 0}open(){this.retryTimer=void 0;let e=this.make();this.socket=e,this.silent_ms=0,e.onopen=()=>{this.isOpen=!0,this.silent_ms=0,this.retry_ms=qy,this.events.opened()},e.onmessage=t=>{let n=t.data;this.silent_ms=0,typeof n=="string"?this.events.text(n):n instanceof ArrayBuffer&&this.events.binary(n)},e.onclose=()=>{this.drop()}}watch(){let e=this.now();this.silent_ms+=Math.min(e-this.watched_ms,Yy),this.watched_ms=e,this.socket!==void 0&&this.silent_ms>(this.isOpen?GP:WP)&&this.drop()}drop(){let e=this.socket;if(e===void 0)return;e.onopen=e.onclose=e.onmessage=null,e.close(),this.socket=void 0,this.isOpen=!1;let t=this.retry_ms;this.retry_ms=Math.min(2*t,HP),this.retryTimer=setTimeout(()=>{this.open()},t),this.events.closed(t)}};var ha=class{constructor(e,t,n){this.events=t;this.connection=new qu(e,{opened:()=>{},closed:s=>{this.forget(),t.closed(s)},text:s=>{this.text(s)},binary:s=>{this.binary(s)}},n)}events;connection;listeners=new Map;channels=new Map;services=new Map;subscriptions=new Map;subscribed=new Map;calls=new Map;decoder=new TextDecoder;isReady=!1;nextSubscription=1;nextCall=1;get ready(){return this.isReady&&this.connection.connected}subscribe(e,t){this.listeners.set(e,t),this.subscribeNow([e])}unsubscribe(e){this.listeners.delete(e);let t=this.subscribed.get(e);t!==void 0&&(this.subscribed.delete(e),this.subscriptions.delete(t),this.connection.send(Wy([t])))}call(e,t={}){let n=this.services.get(e);if(!this.ready)return Promise.reject(new Error("not connected"));if(n===void 0)return Promise.reject(new Error(`the server has no service "${e}"`));let s=this.nextCall++;return new Promise((r,o)=>{this.calls.set(s,{resolve:r,reject:o}),this.connection.send($y(n,s,t))})}setParameter(e,t){return this.connection.send(Xy(e,t,`set ${e}`))}retryNow(){this.connection.retryNow()}end(){this.connection.end()}text(e){let t=Vy(e);switch(t?.op){case"serverInfo":this.events.serverInfo({sessionId:t.sessionId,metadata:t.metadata});break;case"advertise":for(let{id:n,topic:s}of t.channels)this.channels.set(s,n);this.isReady&&this.subscribeNow([...this.listeners.keys()]);break;case"unadvertise":for(let[n,s]of[...this.channels])t.channelIds.includes(s)&&this.channels.delete(n);break;case"advertiseServices":for(let{id:n,name:s}of t.services)this.services.set(s,n);if(this.isReady)break;this.isReady=!0,this.events.ready(),this.subscribeNow([...this.listeners.keys()]);break;case"unadvertiseServices":for(let[n,s]of[...this.services])t.serviceIds.includes(s)&&this.services.delete(n);break;case"parameterValues":this.events.parameters(t.parameters);break;case"serviceCallFailure":this.settle(t.callId)?.reject(new Error(t.message));break;case"status":this.events.status(t.level,t.message);break;case void 0:break}}binary(e){let t=Hy(e);if(t?.op==="message"){let n=this.subscriptions.get(t.subscriptionId);if(n===void 0)return;let s=this.json(t.payload);s!==void 0&&n(s,t.time_s)}else t?.op==="serviceResponse"&&this.settle(t.callId)?.resolve(this.json(t.payload))}json(e){try{return JSON.parse(this.decoder.decode(e))}catch{return}}subscribeNow(e){if(!this.ready)return;let t=[];for(let n of e){let s=this.channels.get(n),r=this.listeners.get(n);if(s===void 0||r===void 0||this.subscribed.has(n))continue;let o=this.nextSubscription++;this.subscriptions.set(o,r),this.subscribed.set(n,o),t.push({id:o,channelId:s})}t.length>0&&this.connection.send(Gy(t))}settle(e){let t=this.calls.get(e);return this.calls.delete(e),t}forget(){this.isReady=!1,this.channels.clear(),this.services.clear(),this.subscriptions.clear(),this.subscribed.clear();let e=[...this.calls.values()];this.calls.clear();for(let t of e)t.reject(new Error("connection lost"))}};var Yu=class{press_;daemon;lastTook_ms=null;get unsent(){return this.press_!==void 0&&!this.press_.sent}get unanswered(){return this.press_!==void 0&&!this.press_.received}press(e){this.press_={at_ms:e,sent:!1,received:!1}}sent(){this.press_!==void 0&&(this.press_.sent=!0)}answered(e,t){this.press_!==void 0&&(e?(this.press_=void 0,this.lastTook_ms=t,this.daemon!==void 0&&(this.daemon={...this.daemon,latched:!0,status:"acknowledged",acknowledged_ms:t})):this.press_.received=!0)}disconnected(){this.press_!==void 0&&(this.press_.sent=!1,this.press_.received=!1)}received(e){this.daemon=e,this.lastTook_ms=e.acknowledged_ms??this.lastTook_ms,this.press_?.received===!0&&(e.status==="acknowledged"||!e.latched)&&(this.press_=void 0)}view(e){let t=this.press_;if(t!==void 0){let s=e-t.at_ms;return s<200?{kind:"pending"}:{kind:"not_acknowledged",since_ms:s,waiting:!t.sent}}let n=this.daemon;return n?.latched!==!0?{kind:"ready"}:n.status==="acknowledged"||n.status==="none"?{kind:"stopped",took_ms:n.acknowledged_ms??this.lastTook_ms,by:n.by}:n.status==="pending"?{kind:"pending"}:{kind:"not_acknowledged",since_ms:200,waiting:!1}}};var XP=250,$P=300,Ku=class{constructor(e,t,n=()=>!0){this.client=e;this.make=t;this.mine=n}client;make;mine;button=new Yu;second;press(e){this.button.press(e),this.client.ready?this.send():this.client.retryNow(),this.second?.ready===!0?this.sendBy(this.second).catch(()=>{}):this.second?.retryNow(),setTimeout(()=>{this.button.unanswered&&(this.second??=this.connect())},$P)}ready(){this.button.unsent&&this.send()}end(){let e=this.second;this.second=void 0,e?.end()}send(){this.button.sent(),this.sendBy(this.client).catch(()=>{this.button.disconnected(),setTimeout(()=>{this.button.unsent&&this.client.ready&&this.send()},XP)})}async sendBy(e){let t=await e.call("stop");this.button.answered(t?.acknowledged===!0,typeof t?.acknowledged_ms=="number"?t.acknowledged_ms:null),this.second?.ready===!0&&this.end()}connect(){let e=!1,t=new ha(this.make,{serverInfo:n=>{e=this.mine(n)},ready:()=>{e&&this.button.unanswered?this.sendBy(t).catch(()=>{}):this.end()},closed:()=>{this.button.unanswered||this.end()},status:()=>{},parameters:()=>{}});return t}};var Zy="tp100.alerts";var Zu=class{constructor(e,t,n=()=>performance.now()){this.outlets=e;this.storage=t;this.now=n;let s=(t.getItem(Zy)??"").split(" ");this.notifies_=s.includes("notify"),this.sounds_=s.includes("sound")}outlets;storage;now;notifies_=!1;sounds_=!1;wasLow=!1;quietUntil_ms=-1/0;get notifies(){return this.notifies_}set notifies(e){this.notifies_=e,this.remember()}get sounds(){return this.sounds_}set sounds(e){this.sounds_=e,this.remember()}received(e,t,n){e==="/event"&&this.event(t,n.get("/state")?.t_s),e==="/state"&&(n.battery.low&&!this.wasLow&&this.raise("the battery is low",`${n.get("/state")?.battery_v?.toFixed(2)??""} V`),this.wasLow=n.battery.low)}event(e,t){e.level!=="error"||t===void 0||e.t_s<t-1||this.raise(e.text,[e.cause,e.fix].filter(n=>n!=="").join(": "))}raise(e,t){let n=this.now();n<this.quietUntil_ms||(this.quietUntil_ms=n+3e3,this.notifies_&&this.outlets.notify(e,t),this.sounds_&&this.outlets.beep())}remember(){this.storage.setItem(Zy,[this.notifies_?"notify":"",this.sounds_?"sound":""].filter(Boolean).join(" "))}};var qP=[880,660],Jy=.22,Um=class{audio;notify(e,t){if(!(!("Notification"in window)||Notification.permission!=="granted"))try{new Notification(`TP100: ${e}`,{body:t,tag:"tp100"})}catch{}}beep(){this.audio??=new AudioContext;let e=this.audio;e.resume(),qP.forEach((t,n)=>{let s=e.createOscillator(),r=e.createGain();s.frequency.value=t,r.gain.value=.2,s.connect(r).connect(e.destination),s.start(e.currentTime+n*Jy),s.stop(e.currentTime+(n+1)*Jy)})}},Ju=class{alerts;elements;constructor(e){let t=new Um;this.alerts=new Zu(t,localStorage);let n=jy("alert-sound","sound",this.alerts.sounds);n.input.addEventListener("change",()=>{this.alerts.sounds=n.input.checked,n.input.checked&&t.beep()});let s=jy("alert-notify","notify",this.alerts.notifies&&"Notification"in window);s.input.disabled=!("Notification"in window),s.input.disabled&&(s.element.title="This browser permits notifications only on encrypted pages"),s.input.addEventListener("change",()=>{this.alerts.notifies=s.input.checked,s.input.checked&&Notification.requestPermission().then(r=>{r!=="granted"&&(s.input.checked=this.alerts.notifies=!1,e("The browser does not permit notifications of this page; change it in its settings"))})}),this.elements=[x("span",{},"on faults:"),s.element,n.element]}};function jy(i,e,t){let n=x("input",{type:"checkbox",id:i,"aria-label":`On faults: ${e}`});return n.checked=t,{element:x("label",{},n,e),input:n}}var YP=2,ju=class{element=x("figure",{class:"camera-image"});image=x("img",{alt:"Image of the camera",decoding:"sync"});age=x("span",{class:"camera-age"});hide=x("button",{type:"button",id:"camera-image-toggle","aria-expanded":"true"},"hide");received=-1;open=!0;constructor(){this.element.append(this.image,x("figcaption",{},"camera",this.age,this.hide)),this.element.hidden=!0,this.hide.addEventListener("click",()=>{this.open=!this.open,$e(this.hide,"aria-expanded",String(this.open)),Ce(this.hide,this.open?"hide":"show"),this.received=-1})}show(e,t){let n=e.get("/camera/image"),s=n?.format==="jpeg";if(this.element.hidden=!s,dt(document.body,"with-image",s&&this.open),!s){this.received=-1;return}let r=n.timestamp.sec+n.timestamp.nsec*1e-9-(t??NaN),o=(e.get("/estimate")?.t_s??NaN)-r;dt(this.element,"stale",e.stale("/camera/image")||!(o<YP)),Ce(this.age,Number.isFinite(o)?`${Math.max(o,0).toFixed(1)} s ago`:"");let a=e.received["/camera/image"]??0;!this.open||a===this.received||(this.received=a,this.image.src=`data:image/jpeg;base64,${n.data}`,$e(this.element,"data-t_s",r.toFixed(3)))}reset(){this.received=-1}};var Qu=class{constructor(e){this.call=e}call;count;newest;seen;listeners=[];subscribe(e){this.listeners.push(e)}received({stop:e,t_s:t}){let n=this.count!==void 0&&this.count!==e.count;this.count=e.count,this.newest={stops:e.count,t_s:t},n&&this.tell("STOP was pressed")}shown(){this.seen=this.newest}forget(e){this.newest=this.seen=void 0,this.tell(e)}move=(e,t)=>this.seen===void 0?Promise.reject(new Error("nothing was shown of the robot since STOP was pressed or the connection ended; look, then press again")):this.call(e,{...t,...this.seen});tell(e){for(let t of this.listeners)t(e)}},Jr=class{constructor(e,t){this.now=t;e.subscribe(()=>{this.close()})}now;until_ms=-1/0;asked=!1;press(){return this.open&&this.asked?(this.close(),!0):(this.open||(this.asked=!1),this.until_ms=this.now()+3e3,!1)}show(){return this.asked=this.open,this.asked}close(){this.until_ms=-1/0}get open(){return this.now()<this.until_ms}};var Sr=i=>i!=null&&Number.isFinite(i);function Ve(i,e){if(!Sr(i))return"–";let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function Ti(i,e){return Ve(Sr(i)?i*180/Math.PI:null,e)}function Qy(i,e){return Ve(Sr(i)?i*1e3:null,e)}function Fm(i,e){return Ve(Sr(i)?i*100:null,e)}function Yt(i){return Sr(i)?i>0&&i<.95?`${i.toFixed(1)} µs`:i<1e3?`${i.toFixed(0)} µs`:i<1e4?`${(i/1e3).toFixed(1)} ms`:i<1e6?`${(i/1e3).toFixed(0)} ms`:`${(i/1e6).toFixed(1)} s`:"–"}function Ui(i){if(!Sr(i)||i<0)return"–";let e=Math.floor(i*10+1e-6),t=Math.floor(e/10),n=s=>String(s).padStart(2,"0");return t>=3600?`${Math.floor(t/3600)}:${n(Math.floor(t/60)%60)}:${n(t%60)}`:`${Math.floor(t/60)}:${n(t%60)}.${e%10}`}function ex(i){return new Date(1e3*i).toTimeString().slice(0,8)}function Fi(i){if(!Sr(i))return"–";let e=["B","kB","MB","GB"],t=0,n=i;for(;n>=1e3&&t<e.length-1;)n/=1e3,t++;return`${n.toFixed(t===0||n>=100?0:1)} ${e[t]??""}`}function Rn(i){return Sr(i)?Math.round(i).toString().replace(/\B(?=(\d{3})+$)/g," "):"–"}var Vl=i=>i==="arming"||i==="running",Ts="This daemon accepts only STOP from here (server.commands)",ua=i=>Vl(i)||i==="driving";var ed=class{element=x("div",{class:"question",role:"dialog","aria-labelledby":"question-text",hidden:""});text=x("p",{id:"question-text"});first;starts;constructor(e,t){e.subscribe(()=>{this.close()});let n=(s,r,o)=>{let a=x("button",{type:"button",class:"control",id:s},r);return a.addEventListener("click",()=>{this.close(),o()}),a};this.first=n("start-cancel","Cancel",()=>{}),this.starts=[n("start-placed","Placed back at the start: start there",()=>{t("start")}),n("start-here","Go on from here",()=>{t("here")})],this.element.append(this.text,this.first,...this.starts)}get open(){return!this.element.hidden}ask(e){this.element.hidden=!1,this.show(e,!0),this.first.focus()}close(){this.element.hidden=!0}show(e,t){if(!this.open)return;let n=e?.go_on_from;if(n===void 0){this.close();return}for(let o of this.starts)o.disabled=!t,$e(o,"title",t?"":e?.why_not_start??"");let s=`x ${Ve(n.x_m,2)} m, y ${Ve(n.y_m,2)} m, yaw ${Ti(n.yaw_rad,0)}°`,r=`${Ve(e?.progress_m,2)} of ${Ve(e?.length_m,2)} m along the course`;Ce(this.text,`The last run ended before the end of its course. The robot is estimated to be at ${s}, ${r}. Where is it now?`)}};var nd=class{constructor(e,t,n,s=()=>performance.now()){this.call=e;this.consent=t;this.failed=n;this.question=new ed(t,r=>{this.send(t.move("start",{from:r}))}),this.starts=new Jr(t,s),this.continues=new Jr(t,s),this.element.append(this.start.button,this.hold.button,this.record.button,this.pause.button,this.question.element),this.start.button.addEventListener("click",()=>{this.pressStart()}),this.pause.button.addEventListener("click",()=>{this.pressPause()}),this.hold.button.addEventListener("click",()=>{this.pressHold()}),this.record.button.addEventListener("click",()=>{this.send(this.call(this.recording?"record_stop":"record_start",{}))})}call;consent;failed;element=x("div",{class:"controls",role:"group","aria-label":"Run"});start=td("start","play","Start","r");pause=td("pause","pause","Pause","p");hold=td("hold","square","Hold","h");record=td("record","record","Record","");question;starts;continues;state;needsConfirmation=!0;recording=!1;pressStart(){if(!(this.start.button.disabled||this.question.open)){if(this.state?.can.resume===!0){this.continues.press()&&this.send(this.consent.move("resume",{}));return}if(this.state?.go_on_from!==void 0){this.question.ask(this.state);return}(!this.needsConfirmation||this.starts.press())&&this.send(this.consent.move("start",{from:"start"}))}}pressPause(){this.pause.button.disabled||this.send(this.call("pause",{}))}pressHold(){this.hold.button.disabled||this.send(this.call("hold",{}))}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.needsConfirmation=s?.confirm_start!==!1;let o=r&&s.can.start;this.state=s,this.question.show(s,o);let a=s?.can.resume===!0;a?this.starts.close():this.continues.close();let l=(a?this.continues:this.starts).show();this.start.button.disabled=!(o||r&&a),dt(this.start.button,"confirm",l),Ce(this.start.label,l?"Press again":a?"Continue":"Start");let c=`the run ends in ${(s?.pause_left_s??0).toFixed(0)} s`,h=n?s?.why_not_start??"":Ts;$e(this.start.button,"title",a?`Continue the run (r); ${c}`:h===""?"Start the course (r)":h);let u=s?.can.pause===!0;this.pause.button.hidden=!u,this.pause.button.disabled=!(r&&u),dt(this.pause.button,"paused",a),Ce(this.pause.label,a?"Paused":"Pause"),$e(this.pause.button,"title",a?`Paused; ${c}`:"Stand still on the path, armed (p)"),this.hold.button.disabled=!(r&&s.can.hold);let d=e.get("/recording");this.recording=d?.active===!0,this.record.button.disabled=!(r&&(s.can.record||this.recording)),dt(this.record.button,"active",this.recording),Ce(this.record.label,this.recording?Ui(d?.elapsed_s):"Record");let f=d?.available===!1?"No directory to record to: start tp100d with --record DIR":"",g=this.recording?`${d?.run??""}, ${Fi(d?.bytes)}`:f;$e(this.record.button,"title",d?.warning===""||d===void 0?g:d.warning),dt(this.record.button,"warn",(d?.warning??"")!=="")}send(e){e.catch(t=>{this.failed(Ot(t))})}};function td(i,e,t,n){let s=x("span",{class:"button-label"},t),r=x("button",{type:"button",id:i,class:"control"},li(e),s);return n!==""&&r.setAttribute("aria-keyshortcuts",n),{button:r,label:s}}var id=.12;function tx(i,e){let t=x("button",{type:"button",class:"control card-choose"},i.in_force?"In use":"Choose");t.dataset.fixed=String(i.in_force||i.why_not!==""),t.setAttribute("aria-label",`Choose course ${i.name}`),t.addEventListener("click",()=>{e.choose(i)});let n=x("button",{type:"button",class:"link card-edit","aria-label":`Edit course ${i.name}`},"edit");n.dataset.fixed="false",n.addEventListener("click",()=>{e.edit(i)});let s=x("div",{class:"card-buttons"},t,n);i.from!=="given"&&s.append(x("a",{href:`/courses/${i.name}.toml`,download:""},"file")),i.from==="own"&&s.append(KP(i,e));let r=x("li",{class:"card",id:`course-${i.name}`},ZP(i),x("div",{class:"card-text"},x("h3",{},i.name,...i.from==="own"?[x("span",{class:"card-own"}," yours")]:[]),x("p",{class:"card-about"},i.description??""),x("p",{class:"card-facts"},Ll(i))),s);return i.in_force&&r.setAttribute("aria-current","true"),i.why_not!==""&&r.append(x("p",{class:"card-why"},i.why_not)),r}function KP(i,e){let t=x("button",{type:"button",class:"link card-delete"},"delete");return t.dataset.fixed=String(i.in_force),hc(t,"really delete",()=>{e.remove(i)}),t}function ZP(i){let e=sd("svg",{class:"card-outline",role:"img","aria-label":`Outline of course ${i.name}`}),t=i.outline??[];if(t.length===0)return e;let n=p=>(p??[]).map(m=>Ks(m,m.length_m,m.width_m)),s=[...n(i.ramps),...n(i.blocks)],r=[...t.map(({x_m:p,y_m:m})=>({x:p,y:m})),...s.flat()],[o,a]=[r.map(({x:p})=>p),r.map(({y:p})=>p)],[l,c]=[Math.min(...o)-id,Math.max(...a)+id],h=Math.max(...o)+id-l,u=c-Math.min(...a)+id;e.setAttribute("viewBox",`${l} ${-c} ${h} ${u}`);let d=p=>p.map(({x:m,y:b})=>`${m.toFixed(3)},${(-b).toFixed(3)}`).join(" "),f=(p,m)=>{for(let b of p)e.append(sd("polygon",{points:d(b),fill:m}))};f(n(i.surfaces),"var(--surface)"),f(s,"var(--obstacle)");let g=t.map(({x_m:p,y_m:m})=>({x:p,y:m}));e.append(sd("polyline",{points:d(g),fill:"none",stroke:"var(--path)","stroke-width":"1.5","stroke-linejoin":"round","vector-effect":"non-scaling-stroke"}));let y=i.start;if(y!==void 0){let p=.05*Math.max(h,u);e.append(sd("circle",{cx:String(y.x_m),cy:String(-y.y_m),r:String(p),fill:"var(--fused)"}))}return e}function sd(i,e){let t=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[n,s]of Object.entries(e))t.setAttribute(n,s);return t}var JP=5e3,jP={stand:"tracks turn freely, everything else is virtual",flat:"a flat floor; ramps and blocks are virtual",terrain:"ramps and blocks are really there"},QP="The real floor does not change with the course: with set-up terrain its ramps and blocks must stand there. An emulated robot keeps the floor and the disturbances that it was started with.",rd=class{constructor(e,t,n,s=()=>performance.now()){this.ask=e;this.drawPlace=t;this.editor=n;this.now=s;this.element.append(x("div",{class:"courses-bar"},x("label",{},"robot ",this.robots),x("label",{},"set-up ",this.setups),this.placeStart,this.placeMap,this.upload,this.drawNew,this.file),this.why,x("div",{class:"courses-answer"},this.message,this.replace),this.cards,x("p",{class:"courses-floor"},QP)),this.robots.addEventListener("change",()=>{this.change({name:"choose",request:{robot:this.robots.value}})}),this.setups.addEventListener("change",()=>{this.change({name:"choose",request:{setup:this.setups.value}})}),this.placeStart.addEventListener("click",()=>{this.change({name:"place",request:{at:"start"}})}),this.placeMap.addEventListener("click",()=>{this.drawPlace(this.placeMap.getAttribute("aria-pressed")!=="true")}),this.upload.addEventListener("click",()=>{this.file.click()}),this.drawNew.addEventListener("click",()=>{this.editor.openNew(this.list?.courses.map(({name:r})=>r)??[])}),this.file.addEventListener("change",()=>{let r=this.file.files?.[0];r!==void 0&&this.take(r),this.file.value=""}),this.replace.addEventListener("click",()=>{let r=this.replaced;r!==void 0&&this.save(r,!0)}),this.dropFiles()}ask;drawPlace;editor;now;element=x("div",{class:"courses",tabindex:"0"});robots=x("select",{id:"choose-robot","aria-label":"Robot"});setups=x("select",{id:"choose-setup","aria-label":"Set-up"});placeStart=x("button",{type:"button",class:"control",id:"place-start"},"Place at start");placeMap=x("button",{type:"button",class:"control",id:"place-map","aria-pressed":"false"},"Place on the map");upload=x("button",{type:"button",class:"control",id:"upload"},"Upload");drawNew=x("button",{type:"button",class:"control",id:"draw-new"},"Draw a course");file=x("input",{type:"file",accept:".toml","aria-label":"Course or robot file",hidden:""});why=x("p",{class:"courses-why",role:"status"});message=x("p",{class:"courses-message",role:"alert"});replace=x("button",{type:"button",class:"control",id:"upload-replace",hidden:""},"Replace it");cards=x("ol",{class:"cards"});list;shown="";next_ms=0;asking=!1;mayChange=!1;replaced;show(e,t,n){let s=e.get("/state"),r=eR(s,t&&!e.stale("/state"),n);this.mayChange=r===""&&!this.asking,Ce(this.why,r),this.enable();let o=`${s?.course??""} ${s?.robot??""} ${s?.setup??""}`;this.element.dataset.named!==o&&(this.next_ms=0),this.element.dataset.named=o,!(this.now()<this.next_ms||!t)&&(this.next_ms=this.now()+JP,this.load())}get changeable(){return this.mayChange}placed(e){$e(this.placeMap,"aria-pressed","false"),e!==void 0&&this.change({name:"place",request:e})}drawing(e){$e(this.placeMap,"aria-pressed",String(e)),e&&this.say("Press on the map where the robot is, and drag towards where it points.")}enable(){let e=this.mayChange&&this.list!==void 0;for(let t of[this.robots,this.setups,this.placeMap])t.disabled=!e;this.placeStart.disabled=!e||this.list?.course==="",this.drawNew.disabled=this.list===void 0,this.upload.disabled=this.replace.disabled=!e||this.list?.may_save!==!0,$e(this.upload,"title",this.list?.may_save===!1?"There is no folder for your files: set library in the configuration":"A course or robot file (TOML)");for(let t of this.cards.querySelectorAll("button"))t.disabled=!e||t.dataset.fixed==="true"}async load(){try{let e=await fetch("/api/setup",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t,this.list=JSON.parse(t),this.build(this.list)}catch{this.shown="",this.say("The list of courses is not available now.")}}build(e){let t=(o,a,l)=>{let c=x("option",{value:o},a===""?o:`${o}: ${a}`);return c.disabled=l!=="",l!==""&&(c.title=l),c};this.robots.replaceChildren(...e.robots.map(o=>t(o.name,o.description??"",o.why_not))),this.robots.value=e.robot,this.setups.replaceChildren(...e.setups.map(o=>t(o,jP[o]??"",""))),this.setups.value=e.setup;let n=o=>+(o.identifies===!0)-+(o.from!=="bundled"),s=[...e.courses].sort((o,a)=>n(o)-n(a)),r={edit:o=>{this.edit(o)},choose:({name:o})=>{this.change({name:"choose",request:{course:o}})},remove:({name:o})=>{this.change({name:"file_delete",request:{kind:"course",name:o}})}};this.cards.replaceChildren(...s.map(o=>tx(o,r))),this.enable()}async edit({name:e,from:t}){try{let n=await fetch(`/courses/${e}.toml`,{cache:"no-store"});if(!n.ok)throw new Error(`${e} cannot be read: ${n.statusText}`);let s=t==="own";this.editor.open(s?e:`${e}-mine`,await n.text(),s)}catch(n){this.say(Ot(n))}}async change(e){this.asking=!0,this.mayChange=!1,this.say(""),this.enable();try{return await this.ask(e),!0}catch(t){return this.say(Ot(t)),!1}finally{this.asking=!1,this.shown="",this.next_ms=0}}async take(e){if(e.size>6e4){this.say(`${e.name} has ${e.size} bytes; at most ${6e4} are taken`);return}let t=await e.text();await this.save({kind:Iv(t),name:sa(e.name),text:t},!1)}async save(e,t){let n=e.kind==="course"?this.list?.courses:this.list?.robots;if(!t&&n?.some(({name:s,from:r})=>s===e.name&&r==="own")===!0){this.say(`You have a ${e.kind} named ${e.name} already.`),this.replaced=e,this.replace.hidden=!1;return}await this.change({name:"file_save",request:{...e,replace:t}})&&this.say(`${e.name} is saved.`)}say(e){this.replaced=void 0,this.replace.hidden=!0,Ce(this.message,e)}dropFiles(){this.element.addEventListener("dragover",e=>{e.preventDefault(),this.element.classList.add("dropping")}),this.element.addEventListener("dragleave",()=>{this.element.classList.remove("dropping")}),this.element.addEventListener("drop",e=>{e.preventDefault(),this.element.classList.remove("dropping");let t=e.dataTransfer?.files[0];t!==void 0&&!this.upload.disabled&&this.take(t)})}};function eR(i,e,t){return!e||i===void 0?"No connection to tp100d.":t?Vl(i.run)?"A run is under way: nothing can be changed.":i.run==="driving"?"The robot is driven by hand: release it first.":"":`${Ts}.`}var od=[{part:"port",title:"Port"},{part:"robot",title:"Robot"},{part:"machine",title:"Machine"}],Bm=(i,e)=>`${i} ${e}${i===1?"":"s"}`;function ad(i,e=""){let t=l=>i.filter(c=>c.severity===l).length,[n,s,r]=[t("error"),t("warning"),t("note")],o=n>0?"Not ready to drive":"Ready to drive";return`${e===""?o:n>0?`${e} are not as they should be`:`${e} are as they should be`}: ${Bm(n,"error")}, ${Bm(s,"warning")}, ${Bm(r,"note")}.`}function ld({severity:i,name:e,seen:t,fix:n}){let s=x("div",{class:"finding-about"},x("p",{},t));return n!==""&&s.append(x("p",{class:"finding-fix"},`To do: ${n}`)),x("li",{class:"finding","data-severity":i,"data-name":e},x("span",{class:"finding-severity"},i),x("strong",{},e),s)}var ix=40,cd=class{constructor(e,t,n,s,r,o){this.call=e;this.move=t;this.seen=n;this.now_ms=s;this.progress=r;this.failed=o}call;move;seen;now_ms;progress;failed;token="";beginning=!1;answered;get on(){return this.beginning||this.token!==""}async begin(){if(!this.on){this.beginning=!0;try{let{token:e}=await this.move("wheels_up_begin",{tracks:"free"});this.token=e}catch(e){this.end(e)}finally{this.beginning=!1}}}answer(e,t){this.answered={question:e,answer:t}}async tick(){let e=this.token;if(e===""||!this.seen())return;let t=this.answered;this.answered=void 0;try{let n=await this.call("wheels_up_watch",{token:e,input_ms:this.now_ms(),...t});if(this.token!==e)return;n.result!==void 0&&(this.token=""),this.progress(n)}catch(n){this.token===e&&this.end(n)}}end(e){this.token="",this.failed(Ot(e))}};var hd=class{element=x("section",{class:"wheels-up","aria-label":"Wheels up"});free=x("input",{type:"checkbox",id:"wheels-up-free"});start=x("button",{type:"button",class:"control",id:"wheels-up-start"},"Run the tracks");message=x("p",{class:"doctor-message wheels-up-message",role:"status"},"Both tracks run in opposite directions, then each one forward and back for a second, as long as this page is in sight. STOP ends it.");question=x("div",{class:"wheels-up-question",role:"group","aria-label":"Question",hidden:""});list=x("ul",{});check;asked=-1;constructor(e,t){t.subscribe(()=>{this.free.checked=!1}),this.check=new cd(e,t.move,()=>document.visibilityState==="visible"&&document.hasFocus(),()=>performance.now(),n=>{this.progress(n)},n=>{this.say(n,!0)}),this.element.append(x("h3",{},"Wheels up"),x("div",{class:"wheels-up-bar"},x("label",{},this.free," The robot stands on a block, and both tracks turn freely"),this.start),this.message,this.question,this.list),this.start.addEventListener("click",()=>{this.free.checked=!1,this.list.replaceChildren(),this.say("…"),this.check.begin()}),setInterval(()=>{this.check.tick()},ix)}get on(){return this.check.on}show(e){this.free.disabled=e!==""||this.check.on,this.start.disabled=this.free.disabled||!this.free.checked,$e(this.start,"title",e),this.check.on||(this.question.hidden=!0)}progress({step:e,question:t,result:n}){n!==void 0?(this.say(ad(n.findings,"The tracks"),n.errors>0),this.list.replaceChildren(...n.findings.map(ld))):this.say(e),this.question.hidden=t===void 0,t!==void 0&&t.number!==this.asked&&this.ask(t)}ask({number:e,text:t,choices:n}){this.asked=e;let s=n.map(({answer:r,meaning:o})=>{let a=x("button",{type:"button",class:"control","data-answer":r},o);return a.addEventListener("click",()=>{this.check.answer(e,r)}),a});this.question.replaceChildren(x("p",{},t),...s)}say(e,t=!1){Ce(this.message,e),dt(this.message,"bad",t)}};var ud=class{constructor(e,t){this.call=e;this.wheelsUp=new hd(e,t),this.element.append(x("div",{class:"doctor-bar"},this.button,this.progress,this.message),this.list,this.wheelsUp.element),this.button.addEventListener("click",()=>{this.examine()})}call;element=x("div",{class:"doctor",tabindex:"0"});button=x("button",{type:"button",class:"control",id:"doctor-examine"},"Examine");message=x("p",{class:"doctor-message",role:"status"},"Finds what keeps the robot from driving. Nothing moves.");progress=x("progress",{max:String(od.length),value:"0","aria-label":"Examined",hidden:""});list=x("div",{class:"doctor-list"});wheelsUp;busy=!1;show(e,t,n){let s=e.get("/state")?.run,r=ua(s);this.button.disabled=this.busy||this.wheelsUp.on||!t||!n||r;let o=n?r?"A run is under way; stop it first":"":Ts;$e(this.button,"title",o),this.wheelsUp.show(t?o!==""?o:this.busy?"Examining":e.get("/state")?.why_not_drive??"":"No connection to tp100d")}async examine(){this.busy=this.button.disabled=!0,this.progress.hidden=!1,this.list.replaceChildren();let e=[],t="";for(let[n,{part:s,title:r}]of od.entries()){this.progress.value=n,this.say(`${r}, ${n+1} of ${od.length} …`);try{let{findings:o}=await this.call("doctor",{part:s});e.push(...o),this.list.append(x("section",{"data-part":s,"aria-label":r},x("h3",{},r),x("ul",{},...o.map(ld))))}catch(o){t=`${r} not examined: ${Ot(o)}`;break}}this.progress.hidden=!0,this.busy=!1,this.say(t===""?ad(e):t,t!==""||e.some(({severity:n})=>n==="error"))}say(e,t=!1){Ce(this.message,e),dt(this.message,"bad",t)}};var tR={none:"no control held",keys:"keys",stick:"stick",gamepad:"gamepad"},dd=class{constructor(e,t,n,s=()=>performance.now()){this.driver=e;this.inputs=t;this.confirmation=new Jr(n,s),this.stick=new zm(r=>{t.touch(r),e.tick()}),this.button.append(li("wheel"),this.label),this.button.addEventListener("click",()=>{this.press()}),this.release.addEventListener("click",()=>{e.release()}),this.share.addEventListener("input",()=>{e.share=this.share.valueAsNumber/100});for(let[r,o]of[["speed","speed"],["turn","turn"]]){let a=x("dd",{id:`drive-${r}`});this.values.set(r,a),this.facts.append(x("dt",{},o),a)}this.element.append(this.stick.element,x("div",{class:"drive-text"},this.source,this.facts,x("label",{class:"drive-limit",for:"drive-share"},"at most ",this.shareText),this.share,this.asked),this.release)}driver;inputs;button=x("button",{type:"button",id:"drive",class:"control","aria-keyshortcuts":"m"});element=x("section",{class:"drive-panel","aria-label":"Driving by hand",hidden:""});label=x("span",{class:"button-label"},"Drive");stick;source=x("p",{class:"drive-source",role:"status"});facts=x("dl",{class:"drive-facts"});values=new Map;share=x("input",{type:"range",id:"drive-share",min:"10",max:"100",step:"5",value:"50","aria-label":"Greatest speed"});shareText=x("output",{for:"drive-share"});asked=x("p",{class:"drive-asked",role:"status"});release=x("button",{type:"button",class:"control",id:"drive-release"},"Release");confirmation;needsConfirmation=!0;press(){this.button.disabled||this.driver.drives||(!this.needsConfirmation||this.confirmation.press())&&this.driver.take()}show(e,t,n){let s=e.get("/state"),r=t&&n&&s!==void 0&&!e.stale("/state");this.showButton(s,r,n);let o=this.driver.drives;if(this.element.hidden===o&&(this.element.hidden=!o),!o){this.stick.letGo();return}let a=e.get("/parameter")?.parameters??[],l=(c,h)=>{let u=a.find(d=>d.name===c)?.value;return typeof u=="number"?u:h};this.driver.limits={speed_mps:l("robot.drive.max_track_mps",.2),yaw_rate_radps:l("robot.drive.max_yaw_radps",1)},this.showDrive(e,s)}showButton(e,t,n){this.needsConfirmation=e?.confirm_start!==!1;let s=e?.driver?.fresh===!0&&!this.driver.drives;this.button.disabled=!(t&&!this.driver.drives&&(e?.can.drive===!0||s)),this.button.hidden=e?.can.pause===!0;let r=this.confirmation.show();dt(this.button,"confirm",r),Ce(this.label,r?"Press again":s?"Ask":"Drive");let o=n?e?.why_not_drive??"":Ts,a=s?`${o}: ask for the wheel`:o;$e(this.button,"title",a===""?"Drive by hand (m)":a)}showDrive(e,t){let n=this.driver.wish,s=e.get("/estimate"),r=s?.[s.steering],o=t?.run==="driving";dt(this.element,"frozen",this.inputs.frozen);let a=this.inputs.frozen?"gamepad: its values do not change; move the stick":this.inputs.silent?"keys: the keyboard does not repeat them; press again":o?s?.at_fence===!0?"at the fence":tR[n?.source??"none"]:"arming…";Ce(this.source,a);let{speed_mps:l,yaw_rate_radps:c}=this.driver.limits,h=`${Ve(r?.vx_mps,3)} m/s, commanded ${Ve(s?.desired_speed_mps,3)}`,u=`${Ti(r?.yaw_rate_radps,0)}°/s, wanted ${Ti((n?.left??0)*this.driver.share*c,0)}`,[d,f]=[this.values.get("speed"),this.values.get("turn")];d&&Ce(d,h),f&&Ce(f,u);let g=this.driver.share*l;Ce(this.shareText,`${Ve(g,2)} of ${Ve(l,2)} m/s, ${Ti(this.driver.share*c,0)}°/s`);let y=t?.driver?.asked_by??"";Ce(this.asked,y===""?"":`${y} asks for the wheel`),this.stick.show(n?.forward??0,n?.left??0)}},zm=class{constructor(e){this.moved=e;this.element.append(this.knob),this.element.addEventListener("pointerdown",t=>{this.pointer!==void 0||t.button!==0||(t.preventDefault(),this.pointer=t.pointerId,this.element.setPointerCapture(t.pointerId),this.move(t))}),this.element.addEventListener("pointermove",t=>{t.pointerId===this.pointer&&(t.buttons===0?this.letGo():this.move(t))});for(let t of["pointerup","pointercancel","lostpointercapture"])this.element.addEventListener(t,n=>{n.pointerId===this.pointer&&this.letGo()})}moved;element=x("div",{class:"drive-stick","aria-hidden":"true"});knob=x("div",{class:"drive-knob"});pointer;letGo(){this.pointer!==void 0&&(this.pointer=void 0,this.moved(void 0))}show(e,t){this.knob.style.transform=`translate(${(-75*t).toFixed(1)}%, ${(-75*e).toFixed(1)}%)`}move(e){let t=this.element.getBoundingClientRect(),n=t.width/2,s=(e.clientX-t.left-n)/n,r=(e.clientY-t.top-n)/n,o=Math.max(1,Math.hypot(s,r)),a=l=>Math.abs(l)<.08?0:l;this.moved({forward:a(-r/o),left:a(-s/o)})}};var fd=class{constructor(e,...t){this.pages=e;let n=x("div",{class:"tabs",role:"tablist"});this.tabs=e.map((r,o)=>{let a=x("button",{type:"button",role:"tab",id:`tab-${r.id}`,"aria-controls":`page-${r.id}`},r.title);return a.addEventListener("click",()=>{this.choose(o)}),a.addEventListener("keydown",l=>{let c={ArrowRight:1,ArrowLeft:-1}[l.key];c!==void 0&&(this.choose((this.current+c+e.length)%e.length),this.tabs[this.current]?.focus())}),a}),n.append(...this.tabs);let s=x("button",{type:"button",id:"drawer-size","aria-pressed":"false",title:"More room for these pages"},"larger");s.addEventListener("click",()=>{let r=document.body.classList.toggle("large-drawer");$e(s,"aria-pressed",String(r)),Ce(s,r?"smaller":"larger")}),this.element.append(x("div",{class:"drawer-head"},n,...t,s));for(let r of e)$e(r.element,"id",`page-${r.id}`),$e(r.element,"role","tabpanel"),$e(r.element,"aria-labelledby",`tab-${r.id}`),r.element.classList.add("page"),this.element.append(r.element);this.choose(0)}pages;element=x("section",{class:"drawer","aria-label":"Details"});tabs;current=0;show(){this.pages[this.current]?.show()}get selected(){return this.pages[this.current]?.id??""}select(e){this.choose(this.pages.findIndex(t=>t.id===e))}choose(e){this.current=e,this.pages.forEach((t,n)=>{let s=n===e;t.element.hidden=!s;let r=this.tabs[n];r!==void 0&&($e(r,"aria-selected",String(s)),r.tabIndex=s?0:-1)}),this.show()}};var pd=class{since_s;low=!1;limit_v=NaN;take(e,t,n){this.limit_v=n??NaN;let s=this.limit_v+.3;if(!(typeof t=="number"&&t>4&&n!==void 0&&n>0)||t>s+(this.low?.1:0)){this.since_s=void 0,this.low=!1;return}(this.since_s===void 0||e<this.since_s)&&(this.since_s=e),e-this.since_s>=2&&(this.low=!0)}};var da=class{constructor(e,t,n=0){this.width=e;this.capacity=t;this.interval_s=n;this.columns=Array.from({length:e},()=>new Float64Array(2*t))}width;capacity;interval_s;columns;end=0;filled=0;get length(){return this.filled}get first_s(){return this.filled===0?NaN:this.columns[0]?.[this.end-this.filled]??NaN}get last_s(){return this.filled===0?NaN:this.columns[0]?.[this.end-1]??NaN}push(e){let t=e[0]??NaN;if(this.filled>0){if(t<this.last_s)this.clear();else if(t-this.last_s<this.interval_s)return}if(this.end===2*this.capacity){for(let n of this.columns)n.copyWithin(0,this.capacity);this.end=this.capacity}for(let n=0;n<this.width;n++){let s=this.columns[n];s!==void 0&&(s[this.end]=e[n]??NaN)}this.end++,this.filled=Math.min(this.filled+1,this.capacity)}before(e){let t=this.since(-1/0).map(r=>r.slice()),n=this.filled,s=n===0?1/0:this.first_s;this.clear();for(let r of e)(r[0]??NaN)<s&&this.push(r);for(let r=0;r<n;r++)this.push(t.map(o=>o[r]??NaN))}clear(){this.end=0,this.filled=0}since(e){let t=this.columns[0],n=this.end-this.filled,s=this.end;for(;t!==void 0&&n<s;){let o=n+s>>1;(t[o]??1/0)<e?n=o+1:s=o}let r=Math.max(n-1,this.end-this.filled);return this.columns.map(o=>o.subarray(r,this.end))}};var jr=class{constructor(e=4e3,t=.01){this.capacity=e;this.firstSpacing_m=t;this.points=new Float32Array(3*e),this.spacing_m=t}capacity;firstSpacing_m;points;count=0;spacing_m;changes=0;get length(){return this.count}get generation(){return this.changes}get coordinates(){return this.points.subarray(0,3*this.count)}add(e,t,n){if(!Number.isFinite(e+t+n))return;let s=3*(this.count-1);this.count>0&&Math.hypot(e-(this.points[s]??0),t-(this.points[s+1]??0))<this.spacing_m*.999||(this.count===this.capacity&&this.thin(),this.points.set([e,t,n],3*this.count),this.count++)}clear(){this.count=0,this.spacing_m=this.firstSpacing_m,this.changes++}thin(){let e=this.count>>1;for(let t=0;t<e;t++)this.points.copyWithin(3*t,6*t,6*t+3);this.count=e,this.spacing_m*=2,this.changes++}};var Gl=["model","odometry","fused"],oi=[...Gl,"truth"],Vm={t_s:0,desired_yaw_deg:1,model_yaw_deg:2,odometry_yaw_deg:3,fused_yaw_deg:4,truth_yaw_deg:5,cross_track_mm:6,heading_error_deg:7,left_mps:8,right_mps:9,left_commanded_mps:10,right_commanded_mps:11,slip_left_percent:12,slip_right_percent:13,fused_slip_left_percent:14,fused_slip_right_percent:15,model_error_mm:16,odometry_error_mm:17,fused_error_mm:18},Hm=120,sx=.0199,Gm=300,nR=.5,iR={"/estimate":400,"/slip":600,"/sample":400,"/command":400,"/link":1e3,"/loop":1500,"/state":1e3,"/course":1/0,"/event":1/0,"/parameter":1/0,"/recording":1/0,"/client":3e3,"/path_history":1/0,"/camera/image":2500},sR=4e5,Hl=class{constructor(e=()=>performance.now()){this.now=e}now;series=new da(Object.keys(Vm).length,Math.ceil(Hm/sx),sx);path_histories={model:new jr,odometry:new jr,fused:new jr,truth:new jr};events=[];battery=new pd;leftTrack_m=0;rightTrack_m=0;received={};latest={};received_ms={};get(e){return this.latest[e]}receive(e,t){e==="/estimate"?this.estimate(t):e==="/event"?this.event(t):e==="/state"?this.state(t):e==="/path_history"&&this.history(t),this.latest[e]=t,this.received_ms[e]=this.now(),this.received[e]=(this.received[e]??0)+1}stale(e){let t=this.received_ms[e];if(t===void 0||this.now()-t>iR[e])return!0;if(e!=="/estimate"&&e!=="/slip")return!1;let n=this.latest["/estimate"]?.age_us;return n==null||n>sR}get pose(){let e=this.latest["/estimate"];return e?.[e.steering]}before(e,t){let n=0;this.series.before(e.map(s=>{for(;(t[n+1]?.t_s??1/0)<=s.t_s;)n++;return rx(s,t[n])}))}clear(){this.series.clear(),this.clearTrails(),this.events.length=0,this.leftTrack_m=this.rightTrack_m=0;for(let e of Object.keys(this.latest))Reflect.deleteProperty(this.latest,e)}clearTrails(){for(let e of oi)this.path_histories[e].clear()}estimate(e){let t=this.latest["/estimate"];if(t!==void 0){let n=e.t_s-t.t_s;n>0&&n<1&&(this.leftTrack_m+=e.tracks.left_mps*n,this.rightTrack_m+=e.tracks.right_mps*n),(Math.hypot(e.model.x_m-t.model.x_m,e.model.y_m-t.model.y_m)>nR||n<0)&&this.clearTrails()}for(let n of oi){let s=e[n];s&&this.path_histories[n].add(s.x_m,s.y_m,s.z_m)}this.series.push(rx(e,this.latest["/slip"]))}event(e){this.events.some(n=>n.t_s===e.t_s&&n.text===e.text)||(this.events.push(e),this.events.length>Gm&&this.events.shift())}state(e){e.run==="running"&&this.latest["/state"]?.run==="arming"&&this.clearTrails();let n=this.latest["/parameter"]?.parameters.find(({name:s})=>s==="control.min_battery_v")?.value;this.battery.take(e.t_s,e.battery_v,typeof n=="number"?n:void 0)}history(e){for(let t of["model","odometry","fused"]){let n=this.path_histories[t];if(n.length>10)continue;let s=e.entities.filter(r=>r.id.startsWith(`path_history/${t}/`));if(s.length!==0){n.clear();for(let r of s)for(let o of r.lines)for(let{x:a,y:l,z:c}of o.points)n.add(a,l,c)}}}};function rx(i,e){let{model:t,odometry:n,fused:s,truth:r,tracks:o}=i,a=c=>(c??NaN)*180/Math.PI,l=c=>r?1e3*Math.hypot(c.x_m-r.x_m,c.y_m-r.y_m):NaN;return[i.t_s,a(i.desired_yaw_rad),a(t.yaw_rad),a(n.yaw_rad),a(s.yaw_rad),a(r?.yaw_rad),1e3*i.cross_track_m,a(i.heading_error_rad),o.left_mps,o.right_mps,o.left_commanded_mps??NaN,o.right_commanded_mps??NaN,100*(e?.left??NaN),100*(e?.right??NaN),100*(e?.fused_left??NaN),100*(e?.fused_right??NaN),l(t),l(n),l(s)]}var rR=["info","warning","error"],md=class{element=x("div",{class:"events",tabindex:"0"});list=x("ol",{class:"event-list"});level=x("select",{"aria-label":"Level of events"});search=x("input",{type:"search",placeholder:"search","aria-label":"Search events"});none=x("p",{class:"empty",hidden:""},"No event matches.");shown=[];source;began_unix_s;constructor(e=[]){["all events","warnings, errors","errors"].forEach((t,n)=>{this.level.append(x("option",{value:String(n)},t))});for(let t of[this.level,this.search])t.addEventListener("input",()=>{this.narrow()});this.element.append(x("div",{class:"events-bar"},this.level,this.search,...e),x("div",{role:"log"},this.list),this.none)}show(e,t){(e!==this.source||e.events.length===0||t!==this.began_unix_s)&&(this.source=e,this.began_unix_s=t,this.shown=[],this.list.replaceChildren());let n=this.shown.at(-1),s=n===void 0?0:e.events.lastIndexOf(n)+1;if(s!==e.events.length){for(let r of e.events.slice(s))this.list.prepend(oR(r,t));for(;this.list.children.length>Gm;)this.list.lastElementChild?.remove();this.shown=e.events.slice(-1),this.narrow()}}narrow(){let e=this.search.value.trim().toLowerCase().split(/\s+/),t=this.list.children.length===0;for(let n of this.list.children){if(!(n instanceof HTMLElement))continue;let s=n.textContent.toLowerCase();n.hidden=rR.indexOf(n.dataset.level??"")<Number(this.level.value)||!e.every(r=>s.includes(r)),t||=!n.hidden}this.none.hidden=t}};function oR(i,e){let t=[i.cause,i.fix].filter(r=>r!=="").join(" — "),n=Ui(i.t_s),s=e===void 0?n:ex(e+i.t_s);return x("li",{class:"event","data-level":i.level,"data-kind":i.kind},x("time",{title:`${n} since the start of tp100d`},s),x("span",{class:"event-kind"},i.kind),x("span",{class:"event-text"},i.text,...t===""?[]:[x("span",{class:"event-cause"},t)]))}var gd=class{element;bars=x("div",{class:"bars",role:"img"});labels=x("div",{class:"bar-labels","aria-hidden":"true"});figures;edges="";shown=-1;constructor(){let e=()=>x("span",{class:"plot-value wide"});this.figures={p50:e(),"p99.9":e(),max:e()};let t=x("div",{class:"plot-key"});for(let[n,s]of Object.entries(this.figures))t.append(x("span",{class:"plot-curve"},n,s));this.element=x("section",{class:"plot histogram",id:"plot-lateness","aria-label":"Lateness of the loop"},x("header",{},x("h2",{},"Loop lateness",x("span",{class:"plot-unit"},"cycles, log")),t),this.bars,this.labels)}show(e){let t=e.get("/loop");dt(this.element,"stale",e.stale("/loop"));let n=e.received["/loop"]??0;if(t===void 0||n===this.shown)return;this.shown=n;let{edges_us:s,lateness:r}=t.histogram;this.build(s);let o=Math.log10(Math.max(10,...r)+1);r.forEach((l,c)=>{let h=this.bars.children[c];if(h===void 0)return;h.style.transform=`scaleY(${(l===0?0:Math.max(.02,Math.log10(l+1)/o)).toFixed(3)})`;let u=c===0?"below ":`${Yt(s[c-1])} to `;$e(h,"title",`${c===s.length?"over "+Yt(s.at(-1)):u+Yt(s[c])}: ${Rn(l)}`)}),Ce(this.figures.p50,Yt(t.lateness_us.p50)),Ce(this.figures["p99.9"],Yt(t.lateness_us.p999)),Ce(this.figures.max,Yt(t.lateness_us.max));let a=`median ${Yt(t.lateness_us.p50)}, worst ${Yt(t.lateness_us.max)} of ${Rn(t.cycles)} cycles`;$e(this.bars,"aria-label",a)}reset(){this.shown=-1,this.edges="",this.bars.replaceChildren(),this.labels.replaceChildren();for(let e of Object.values(this.figures))Ce(e,"")}build(e){let t=e.join();t!==this.edges&&(this.edges=t,this.bars.replaceChildren(...[...e,0].map(()=>x("i"))),this.labels.replaceChildren(...[...e,0].map((n,s)=>{let r=s<e.length&&Number.isInteger(Math.log10(n));return x("span",{},...r?[x("b",{},Yt(n))]:[])})))}};var ox="identify",_d=["distance_m","turned_deg","slope_deg"];function Wm(i){let e=i.calibration.flatMap(t=>i.courses.filter(n=>n.name===t));return[...e,...i.courses.filter(t=>t.identifies===!0&&t.from!=="bundled"&&!e.includes(t))]}function Xm({fence:i}){if(i===void 0)return"";let e=o=>`${Math.max(0,o).toFixed(1)} m`,{min_x_m:t,max_x_m:n,min_y_m:s,max_y_m:r}=i;return`${e(n)} ahead, ${e(-t)} behind, ${e(r)} to the left, ${e(-s)} to the right`}var ax=i=>`${ox} ${i}`;function $m(i,e,t){let n=({name:s,tags:r,active:o})=>{let a=r.split(" ");return s===e&&!o&&a.includes(ox)&&a.includes(t)};return i.filter(n).reverse()}function lx(i){return _d.flatMap(e=>i[e]===void 0?[]:[`${e} = ${i[e]}`]).join(`
`)}function qm(i){let e={};for(let t of _d){let n=new RegExp(`^${t} = (\\S+)$`,"m").exec(i)?.[1];n!==void 0&&Number.isFinite(Number(n))&&(e[t]=Number(n))}return e}function cx(i){let e=i.flatMap(({note:t},n)=>{let s=qm(t);return Object.keys(s).length===0?[]:[`${n+1},${_d.map(r=>s[r]??"").join(",")}
`]});return e.length===0?"":`run,${_d.join(",")}
${e.join("")}`}function hx(i){return i===void 0||!(i>0)?5:Math.min(5,Math.max(0,1-Math.floor(Math.log10(i))))}function ux(i,e){return i.robots.find(({name:t})=>t===e)?.from==="own"?e:`${e}-identified`.slice(0,64)}var lR=2e3,cR=1e3,px=100,hR=1e4,uR=3e3,dx=i=>Vl(i?.run);async function fx(i,e,t){let n=i.now()+e;for(;!t(i.state());){if(i.now()>n)return!1;await i.sleep(px)}return!0}async function mx(i,e){await i.call("choose",{course:e,setup:"flat"})}async function gx(i,e,t){if(await i.call("place",{at:"start"}),!await fx(i,hR,r=>r?.can.start===!0&&r.course===e))throw new Error(i.state()?.why_not_start??"the daemon is gone");t.throwIfAborted();let{run:n}=await i.call("record_start",{}),s="";try{i.say(`${e}: standing still …`),await i.sleep(lR),t.throwIfAborted();let r=await i.ask("It stands still: press again to drive.");if(r===void 0)return"";if(i.now()-r>3e3)throw new Error("The page was held up after the press: nothing was driven");for(await i.move("start",{from:"start"}),i.say(`${e}: driving …`),await fx(i,uR,dx);dx(i.state());)await i.sleep(px);let o=i.state();o?.run!=="finished"&&(s=`${e} was not completed${dR(o)}`),await i.sleep(cR)}finally{await i.call("record_stop",{})}if(s!=="")throw new Error(s);return await i.call("run_note",{run:n,name:e,tags:ax(i.state()?.robot??"")}),n}function dR(i){let e=(i?.faults??[]).map(t=>t.cause);return e.length===0?"":`: ${e.join("; ")}`}async function _x(i,e,t){await i.call("run_note",{run:e,note:lx(t)})}var vd=class{constructor(e,t){this.call=e;this.say=t;this.name.addEventListener("input",()=>{this.named()}),this.save.addEventListener("click",()=>{this.write()}),this.use.addEventListener("click",()=>{this.choose()}),this.always.addEventListener("click",()=>{this.configure()})}call;say;element=x("section",{class:"identify-found","aria-label":"What was identified",hidden:""});name=x("input",{type:"text",id:"identify-name",maxlength:"64","aria-label":"Name of the new robot file"});save=x("button",{type:"button",class:"control",id:"identify-save"},"Save");use=x("button",{type:"button",class:"control",id:"identify-use",hidden:""},"Use it for the next run");always=x("button",{type:"button",class:"control",id:"identify-always",hidden:""},"Use it at every start");kept=x("p",{class:"identify-kept"});text="";saved="";setup;may=!1;enable(e){this.may=e;let t=this.robot();this.save.disabled=!e||sa(this.name.value)!==this.name.value||this.name.value===""||t!==void 0&&t.from!=="own",this.use.disabled=this.always.disabled=!e}show({found:e,text:t},n){this.text=t,this.setup=n,this.name.value=ux(n,e.robot);let s=e.parameters.filter(o=>o.found&&o.value!==o.before),r=["parameter","before","identified","95 %"].map(o=>x("th",{scope:"col"},o));this.element.replaceChildren(x("h3",{},`Robot ${e.robot}: ${s.length} of ${e.parameters.length} parameters change`),x("table",{},x("thead",{},x("tr",{},...r)),x("tbody",{},...e.parameters.map(fR))),...e.slopes.map(o=>x("p",{class:"identify-slope"},pR(o))),x("p",{class:"identify-errors"},vx("Errors with the file in use",e.errors_before)),x("p",{class:"identify-errors"},vx("Errors with the new file",e.errors_after)),x("ul",{class:"identify-warnings"},...e.warnings.map(o=>x("li",{},o))),x("div",{class:"identify-buttons"},x("label",{},"save as ",this.name," .toml "),this.save,this.use,this.always),this.kept),this.element.hidden=!1,this.use.hidden=this.always.hidden=!0,this.named()}robot(){return this.setup?.robots.find(({name:e})=>e===this.name.value)}named(){let e=this.robot(),t=e===void 0?"The file in use stays as it is.":e.from==="own"?`${e.name}.toml is replaced and kept as ${e.name}.toml.bak.`:`${e.name} is not one of your own files: give another name.`;Ce(this.kept,t),this.enable(this.may)}async write(){let e=this.name.value;try{await this.call("file_save",{kind:"robot",name:e,text:this.text,replace:this.robot()!==void 0}),this.saved=e,this.use.hidden=this.always.hidden=!1,this.say(`${e}.toml is saved, but not in use: tp100d keeps its present robot, also after a restart, until you choose another one.`)}catch(t){this.say(Ot(t),!0)}}async choose(){try{await this.call("choose",{robot:this.saved}),this.say(`${this.saved} is in use until tp100d ends.`)}catch(e){this.say(Ot(e),!0)}}async configure(){try{await this.call("choose",{robot:this.saved});let{file:e}=await this.call("parameters_save",{robot:this.saved});this.say(`${this.saved} is in use, and from ${e} at every start; an option --robot would have priority.`)}catch(e){this.say(Ot(e),!0)}}};function fR({name:i,before:e,found:t,value:n,half_interval:s}){let r=hx(s),o=x("th",{scope:"row"},i);if(!t||n===void 0)return x("tr",{"data-name":i,"data-found":"false"},o,x("td",{},Ve(e,r)),x("td",{colspan:"2"},"not determined by these drives"));let a=n!==e;return x("tr",{"data-name":i,"data-found":"true"},o,x("td",{},a?x("del",{},Ve(e,r)):Ve(e,r)),x("td",{},a?x("ins",{},Ve(n,r)):Ve(n,r)),x("td",{},`± ${Ve(s,r)}`))}function pR({slope_deg:i,added_left:e,added_right:t}){return`A slope of ${Ve(i,1)}° adds ${Ve(e,3)} to the slip ratio of the left track and ${Ve(t,3)} to that of the right one.`}function vx(i,{rms_m:e,max_m:t,rms_rad:n,runs:s}){if(e!==void 0)return`${i}, against the camera: ${Ve(100*e,2)} cm rms, ${Ve(100*(t??NaN),2)} cm at most, ${Ti(n,2)}° rms.`;let r=l=>{let c=l.flatMap(h=>h===void 0?[]:[Math.abs(h)]);return c.length===0?void 0:Math.max(...c)},o=r(s.map(l=>l.distance_off_m)),a=r(s.map(l=>l.turned_off_rad));return`${i}, against what was measured by hand: ${Ve(o===void 0?null:100*o,2)} cm and ${Ti(a,2)}° at most.`}var mR=5e3,yd=class{constructor(e,t,n=()=>performance.now()){this.call=e;this.now=n;this.reach={call:e,move:t.move,state:()=>this.store?.get("/state"),now:n,sleep:s=>new Promise(r=>setTimeout(r,s)),say:s=>{this.say(s)},ask:s=>this.confirm(s,"Drive","identify-drive-now")},t.subscribe(s=>{this.giveUp(s)});for(let s of["blur","pagehide"])window.addEventListener(s,()=>{this.giveUp("The page was left")});document.addEventListener("visibilitychange",()=>{document.visibilityState!=="visible"&&this.giveUp("The page was left")}),this.found=new vd(e,(s,r)=>{this.say(s,r)}),this.element.append(x("div",{class:"identify-bar"},this.evaluate,this.message),this.why,this.question,this.found.element,this.list),this.evaluate.addEventListener("click",()=>{this.act("Evaluating the drives …",()=>this.identify())})}call;now;element=x("div",{class:"identify",tabindex:"0"});evaluate=x("button",{type:"button",class:"control",id:"identify-evaluate"},"Evaluate");message=x("p",{class:"identify-message",role:"status"},"Drive the courses on a flat floor, evaluate the drives, and save the resulting robot file.");why=x("p",{class:"identify-why",role:"status"});question=x("section",{class:"identify-question",role:"dialog","aria-label":"Before the drive",hidden:""});list=x("ol",{class:"identify-courses"});found;reach;left=new Set;setup;runs=[];store;shown="";next_ms=0;busy=!1;order=Promise.resolve();attended=new AbortController;mayAsk=!1;mayDrive=!1;show(e,t,n){this.store=e;let s=this.whyNot(t&&!e.stale("/state"),n);this.mayDrive=s==="",Ce(this.why,this.busy?"":s),this.mayAsk=t&&n,this.enable(),!(this.now()<this.next_ms||!t)&&(this.next_ms=this.now()+mR,this.load())}whyNot(e,t){if(!e)return"No connection to tp100d.";if(!t)return`${Ts}.`;if(this.store?.get("/recording")?.available===!1)return"Drives are recorded: start tp100d with --record DIR and --stay.";let n=this.store?.get("/state")?.run;return ua(n)?"A run is under way; stop it first.":""}enable(){let e=this.chosen();Ce(this.evaluate,e.length===0?"Evaluate":`Evaluate ${e.length} drive${e.length===1?"":"s"}`),this.evaluate.disabled=this.busy||!this.mayAsk||e.length===0;for(let t of this.element.querySelectorAll(".identify-drive"))t.disabled=this.busy||!this.mayDrive||t.dataset.fixed==="true";for(let t of this.list.querySelectorAll("input"))t.disabled=!this.mayAsk;this.found.enable(!this.busy&&this.mayDrive)}get robot(){return this.store?.get("/state")?.robot??""}chosen(){return this.setup===void 0?[]:Wm(this.setup).flatMap(({name:e})=>$m(this.runs,e,this.robot)).filter(({run:e})=>!this.left.has(e))}inOrder(e){return this.order=this.order.then(e),this.order}load(){return this.inOrder(async()=>{try{let[e,t]=await Promise.all(["/api/setup","/api/runs"].map(async n=>{let s=await fetch(n,{cache:"no-store"});if(!s.ok)throw new Error(s.statusText);return s.text()}));if(this.setup=JSON.parse(e??""),this.runs=JSON.parse(t??"").runs,`${e}${t}`===this.shown||(document.activeElement?.closest(".identify-measured")??null)!==null)return;this.shown=`${e}${t}`,this.list.replaceChildren(...Wm(this.setup).map(n=>this.course(n)))}catch{this.shown="",this.say("The lists of courses and runs are not available now.",!0)}})}keep(e,t){return this.inOrder(async()=>{try{await _x(this.reach,e,t)}catch(n){this.say(Ot(n),!0)}})}course(e){let t=x("button",{type:"button",class:"control identify-drive","aria-label":`Drive ${e.name}`},"Drive …");t.disabled=!0,t.dataset.fixed=String(e.why_not!==""),t.addEventListener("click",()=>{this.act(`${e.name} …`,()=>this.ask(e))});let n=$m(this.runs,e.name,this.robot),s=x("div",{class:"identify-about"},x("h3",{},e.name),x("p",{},`${Ll(e)}, ${Xm(e)}`));return e.why_not!==""&&s.append(x("p",{class:"identify-bad"},e.why_not)),x("li",{"data-course":e.name,"data-driven":String(n.length)},s,t,x("ul",{},...n.map(r=>this.drive(r))))}drive(e){let t=x("input",{type:"checkbox"});t.checked=!this.left.has(e.run),t.addEventListener("change",()=>{t.checked?this.left.delete(e.run):this.left.add(e.run)});let n=qm(e.note),s=(o,a)=>{let l=x("input",{type:"number",step:"any",inputmode:"decimal",name:o});return l.value=n[o]===void 0?"":String(n[o]),l.addEventListener("change",()=>{l.value===""?Reflect.deleteProperty(n,o):n[o]=Number(l.value),this.keep(e.run,{...n}),this.load()}),x("label",{},`${a} `,l)},r=[s("distance_m","distance [m]"),s("turned_deg","turned, left positive [deg]"),s("slope_deg","straight up a slope of [deg]")];return x("li",{"data-run":e.run},x("label",{},t,` ${e.run}`),x("span",{class:"identify-measured"},"by hand: ",...r))}async ask(e){await mx(this.reach,e.name),this.attended=new AbortController;let t=`Put the robot on a flat floor with ${Xm(e)} free. It will drive ${Ll(e)}. Mark where it stands, unless a camera sees it.`;if(await this.confirm(t,"It stands there","identify-start")===void 0||await gx(this.reach,e.name,this.attended.signal)==="")return"Nothing was driven.";let s=this.store?.get("/estimate")?.fused.camera_age_us;return`${e.name} is driven.${typeof s!="number"?" No camera sees the robot: measure the drive and write it down below.":""}`}async confirm(e,t,n){let s=x("button",{type:"button",class:"control",id:n},t),r=x("button",{type:"button",class:"control",id:"identify-cancel"},"Cancel");this.question.replaceChildren(x("p",{},e),x("div",{class:"identify-buttons"},r,s)),this.question.hidden=!1,r.focus();let{signal:o}=this.attended;try{return await new Promise((a,l)=>{s.addEventListener("click",({timeStamp:c})=>{a(c)}),r.addEventListener("click",()=>{a(void 0)}),o.addEventListener("abort",()=>{l(o.reason)})})}finally{this.question.hidden=!0}}giveUp(e){this.attended.abort(new Error(`${e}: nothing was driven`))}async identify(){await this.load();let e=this.chosen(),t=await this.call("run_identify",{runs:e.map(({run:n})=>n).join(" "),measured:cx(e)});return this.setup!==void 0&&this.found.show(t,this.setup),this.element.scrollTop=0,`${e.length} drive${e.length===1?" is":"s are"} evaluated.`}async act(e,t){if(!this.busy){this.busy=!0,this.enable(),this.say(e);try{this.say(await t())}catch(n){this.say(Ot(n),!0)}finally{await this.load(),this.busy=!1}}}say(e,t=!1){Ce(this.message,e),dt(this.message,"bad",t)}};var xd=class{badge=x("span",{class:"badge"});setting=x("span",{class:"setting"});robots=x("a",{class:"robots-link",href:"robots.html","aria-label":"All robots",title:"All robots"},li("grid"));element=x("div",{class:"identity"},this.robots,x("h1",{},"TP100"),this.setting,this.badge);show(e,t){let n=e.get("/state"),s=[n?.robot??t.robot,n?.setup??t.setup].filter(Boolean);Ce(this.setting,s.join(" · "));let r=n===void 0?"TP100":`${n.run} · TP100`;document.title!==r&&(document.title=r);let o=e.get("/link")?.kind;Ce(this.badge,gR(o)),$e(this.badge,"data-kind",o??"")}};function gR(i){return i==="simulated"?"simulated inside the board":i??""}var _R=[["space, esc","STOP"],["r","start, or continue a paused run; asks for confirmation, or where the robot stands"],["p","pause: stands still on the path, armed"],["h","hold: ends the run or the drive and disarms"],["m","drive by hand: takes the wheel; asks for confirmation"],["arrows; w, a, s, d","while this page drives: forwards, left, backwards, right, as long as they are held"],["1, 2, 3, 4","view: chase, top, free, map"],["c","next view"],["[, ]","step through a recording"],["?","this list"],["tab, arrows","from control to control; between the tabs"]];function yx(){let i=x("dl",{class:"keys"});for(let[e,t]of _R)i.append(x("dt",{},x("kbd",{},e)),x("dd",{},t));return x("div",{tabindex:"0"},i)}var bd=({p50:i,p99:e})=>`${Yt(i)}, ${Yt(e)}`,wd=class{element=x("div",{class:"facts",tabindex:"0"});groups=new Map;show(e){let t=e.get("/link"),n=e.get("/loop"),s=e.get("/client");t!==void 0&&(this.group("Link",e.stale("/link"),[["port",t.port],["robot",t.kind??"–"],["firmware",t.firmware??"–"],["session",t.session],["samples",`${Ve(t.samples_hz,1)} Hz`],["in, out",`${Fi(t.in_bytes_ps)}/s, ${Fi(t.out_bytes_ps)}/s`],["round trip",Yt(t.round_trip_us)],["clock",t.clock.valid?`${Ve(t.clock.drift_ppm,1)} ppm ±${Yt(t.clock.uncertainty_us)}`:"–"],["sample age p50",Yt(t.sample_age_us.p50)],["sample age p99.9",Yt(t.sample_age_us.p999)]]),this.group("Counters",e.stale("/link"),Object.entries(t.counters).map(([r,o])=>[r.replaceAll("_"," "),Rn(o)]))),n!==void 0&&this.group("Loop",e.stale("/loop"),[["rate",`${Ve(n.rate_hz,0)} Hz, by ${n.pacing}`],["cycles",Rn(n.cycles)],["overruns, missed",`${Rn(n.overruns)}, ${Rn(n.missed)}`],["lateness p50",Yt(n.lateness_us.p50)],["lateness p99.9",Yt(n.lateness_us.p999)],["lateness max",Yt(n.lateness_us.max)],["work p50",Yt(n.work_us.p50)],["work max",Yt(n.work_us.max)],["compute p50, p99",bd(n.compute_us)],["write p50, p99",bd(n.write_us)],["sample on the wire p50, p99",bd(n.sample_wire_us)],["sample waits p50, p99",bd(n.sample_wait_us)],...Object.entries(n.privileges).map(([r,o])=>[r,o?"granted":"refused"])]),s!==void 0&&this.group("Viewers",e.stale("/client"),[["dropped, refused, closed",[s.dropped_total,s.refused_total,s.closed_total].map(Rn).join(", ")],...s.clients.slice(0,20).map(r=>[`${r.id} ${r.address}`,`${Rn(r.sent)} sent, ${Rn(r.dropped)} dropped`])])}group(e,t,n){let s=this.groups.get(e);if(s===void 0){let o=x("dl");s={box:x("section",{class:"fact-group"},x("h3",{},e),o),list:o},this.groups.set(e,s),this.element.append(s.box)}dt(s.box,"stale",t);let{list:r}=s;for(;r.children.length>2*n.length;)r.lastElementChild?.remove();n.forEach(([o,a],l)=>{r.children.length<2*l+2&&r.append(x("dt"),x("dd"));let[c,h]=[r.children[2*l],r.children[2*l+1]];c&&Ce(c,o),h&&Ce(h,a)})}};var vR=6e3,Sd=class{element=x("div",{class:"notice",role:"status","data-level":"none"});list=x("ul",{id:"notice-list"});more=x("button",{type:"button",id:"notice-more","aria-controls":"notice-list","aria-expanded":"false"});close=x("button",{type:"button",id:"notice-close","aria-label":"Close this notice"},li("close"));answer="";answerUntil_ms=0;all=[];open=!1;closed="";shown="";constructor(){this.element.append(this.list,this.more,this.close),this.more.addEventListener("click",()=>{this.open=!this.open,this.render()}),this.close.addEventListener("click",()=>{this.closed=Ym(this.all),this.answerUntil_ms=0,this.render()})}say(e,t){this.answer=e,this.answerUntil_ms=t+vR,this.closed=""}show(e,t,n,s,r){this.all=yR(e,t,n,r),t&&s<this.answerUntil_ms&&this.all.unshift({level:"warn",what:this.answer,todo:""}),this.render()}render(){this.closed!==""&&this.closed!==Ym(this.all)&&(this.closed="");let e=this.closed===""?this.all:[],t=this.open?e:e.slice(0,1),n=Ym(t);n!==this.shown&&(this.shown=n,this.list.replaceChildren(...t.map(({what:r,todo:o})=>x("li",{},x("strong",{},r)," ",x("span",{},o))))),$e(this.element,"data-level",t[0]?.level??"none");let s=e.length-1;this.more.hidden=s<1,Ce(this.more,this.open?"less":`+${s}`),$e(this.more,"aria-label",this.open?"Show the first notice only":`Show ${s} more`),$e(this.more,"aria-expanded",String(this.open))}},Ym=i=>JSON.stringify(i);function yR(i,e,t,n){if(!e)return[{level:"bad",what:"No connection to tp100d",todo:t>0?"trying again":"connecting"}];let s=i.get("/state");if(s===void 0)return[];let r=[];if(i.stale("/state")&&r.push({level:"bad",what:"The daemon is silent",todo:"grey values are old"}),s.session!=="ready"&&!n){let a=i.get("/link"),l=a===void 0||a.port===""?"No robot":`No robot on ${a.port}`,c=(a?.note??"").replace(`${a?.port??""}: `,"");r.push({level:"warn",what:l,todo:s.session==="closed"?c:s.why_not_start})}let o=s.run==="finished"?"warn":"bad";for(let a of s.faults)a.name!=="stop_requested"&&r.push({level:o,what:a.cause,todo:a.fix});return i.battery.low&&!n&&r.push({level:"warn",what:"The battery is low",todo:`below ${Ve(i.battery.limit_v,2)} V a run is aborted; charge it before the next one`}),r}var xR=[{id:"x",label:"x",unit:"m",topic:"/estimate",text:i=>Ve(i.pose?.x_m,3)},{id:"y",label:"y",unit:"m",topic:"/estimate",text:i=>Ve(i.pose?.y_m,3)},{id:"yaw",label:"yaw",unit:"°",topic:"/estimate",text:i=>Ti(i.pose?.yaw_rad,1)},{id:"climb",label:"pitch, nose up",unit:"°",topic:"/estimate",text:i=>Ti(i.pose===void 0?null:-i.pose.pitch_rad,1)},{id:"cross-track",label:"cross-track",unit:"mm",topic:"/estimate",text:i=>Qy(i.get("/estimate")?.cross_track_m,1)},{id:"heading-error",label:"heading error",unit:"°",topic:"/estimate",text:i=>Ti(i.get("/estimate")?.heading_error_rad,1)},{id:"left",label:"left track",unit:"m/s",topic:"/estimate",text:i=>Ve(i.get("/estimate")?.tracks.left_mps,3)},{id:"right",label:"right track",unit:"m/s",topic:"/estimate",text:i=>Ve(i.get("/estimate")?.tracks.right_mps,3)},{id:"slip-left",label:"slip left",unit:"%",topic:"/slip",text:i=>Fm(i.get("/slip")?.left,1)},{id:"slip-right",label:"slip right",unit:"%",topic:"/slip",text:i=>Fm(i.get("/slip")?.right,1)},{id:"age",label:"data age",unit:"ms",topic:"/estimate",text:i=>Ve(xx(i),(xx(i)??0)<100?1:0)},{id:"battery",label:"battery",unit:"V",topic:"/state",text:i=>Ve(i.get("/state")?.battery_v,2)}];function xx(i){let e=i.get("/estimate")?.age_us??null;return e===null?null:Math.min(Math.max(e/1e3,0),99999)}var Md=class{element=x("section",{class:"numbers","aria-label":"Figures"});rows;constructor(){this.rows=xR.map(e=>{let t=x("output",{class:"number-value",id:`number-${e.id}`},"–"),n=x("div",{class:"number stale"},x("span",{class:"number-label"},e.label),x("span",{class:"number-line"},t,x("span",{class:"number-unit"},e.unit)));return this.element.append(n),{figure:e,tile:n,value:t}})}show(e){for(let{figure:t,tile:n,value:s}of this.rows)Ce(s,t.text(e)),dt(n,"stale",e.stale(t.topic)),t.id==="battery"&&dt(n,"low",e.battery.low)}};function fa(i){return typeof i=="number"?Number(i.toPrecision(10)):i}function Qr(i){return i===""?'""':String(fa(i))}function Wl(i){return i.type==="choice"?i.choices.join(", "):typeof i.min!="number"||typeof i.max!="number"?"":`${Qr(i.min)} to ${Qr(i.max)}${i.unit===""?"":` ${i.unit}`}`}function bx(i,e){if(i.type==="text")return{value:e};let t=e.trim()===""?NaN:Number(e);return Number.isFinite(t)?i.type==="integer"&&!Number.isInteger(t)?{why:`a whole number from ${Wl(i)}`}:t>=(i.min??-1/0)&&t<=(i.max??1/0)?{value:t}:{why:`allowed is ${Wl(i)}`}:{why:`a number from ${Wl(i)}`}}function wx(i){let e=new Map;for(let t of i){let n=t.name.slice(0,Math.max(t.name.lastIndexOf("."),0))||"run";e.set(n,[...e.get(n)??[],t])}return[...e]}function Sx(i,e){let t=`${i.name} ${i.unit} ${i.meaning} ${i.choices.join(" ")}`.toLowerCase();return e.toLowerCase().split(/\s+/).every(n=>t.includes(n))}var Td=class{edits=new Map;inFile=new Map;get(e){return this.edits.get(e)}get names(){return[...this.edits.keys()]}set(e,t){fa(t)===fa(e.value)&&!this.inFile.has(e.name)?this.edits.delete(e.name):this.edits.set(e.name,t)}drop(e){this.edits.delete(e)}file(e){return this.inFile.get(e)}inForce(e){let t={};for(let n of e)n.may_save===!0&&n.type!=="text"&&(t[n.name]=fa(n.value));return t}wanted(e){let t={};for(let n of e){if(n.may_save!==!0)continue;let s=this.edits.get(n.name);s!==void 0?t[n.name]=fa(s):n.live&&(t[n.name]=fa(n.value))}return t}compared(e){this.inFile=new Map(e.differences.map(({name:t,before:n})=>[t,n]))}};var Ed=class{constructor(e,t,n){this.edits=e;this.set=t;this.edited=n;this.filter.addEventListener("input",()=>{this.narrow()})}edits;set;edited;element=x("div",{class:"parameter-list"});filter=x("input",{type:"search",placeholder:"search","aria-label":"Search parameters"});none=x("p",{class:"empty",hidden:""},"No parameter matches.");shown=-1;groups=[];refresh(){this.shown=-1}show(e){let t=e.received["/parameter"]??0;t===this.shown||this.element.contains(document.activeElement?.closest(".parameter-value")??null)||(this.shown=t,this.groups=wx(e.get("/parameter")?.parameters??[]).map(([n,s])=>{let r=s.map(a=>({parameter:a,row:this.row(a)})),o=x("h3",{},n,...n.startsWith("robot.")?[x("span",{}," of the robot’s file")]:[]);return{element:x("section",{"aria-label":n},o,...r.map(({row:a})=>a)),rows:r}}),this.element.replaceChildren(this.none,...this.groups.map(({element:n})=>n)),this.narrow())}narrow(){let e=this.filter.value.trim(),t=!1;for(let{element:n,rows:s}of this.groups){let r=!1;for(let{parameter:o,row:a}of s)a.hidden=!Sx(o,e),r||=!a.hidden;n.hidden=!r,t||=r}this.none.hidden=t}row(e){let t=this.edits.get(e.name),n=this.edits.file(e.name),s=e.value!==e.default,r=x("p",{class:"parameter-why",role:"alert"}),o=[Wl(e),`default ${Qr(e.default)}`].filter(Boolean).join(" · "),a=e.live?e.when==="not running"?"at once, not during a run":"at once":"";return x("div",{class:["parameter",e.live?"live":"",s?"changed":"",t===void 0?"":"edited"].filter(Boolean).join(" "),"data-name":e.name},x("div",{class:"parameter-about"},x("strong",{},e.name),...a===""?[]:[x("span",{class:"parameter-when"},a)],x("p",{},e.meaning),x("p",{class:"parameter-limits"},o),...n===void 0?[]:[x("p",{class:"parameter-file"},`in the file: ${n}`)],r),x("div",{class:"parameter-value"},e.live||e.may_save===!0?this.field(e,t??e.value,r):x("output",{},Qr(e.value)),x("span",{class:"parameter-unit"},e.unit),...t===void 0?[]:[this.back(e)]))}back(e){let t=x("button",{type:"button",class:"link","aria-label":`Discard the change of ${e.name}`},`back to ${Qr(e.value)}`);return t.addEventListener("click",()=>{this.edits.drop(e.name),this.refresh(),this.edited()}),t}take(e,t){if(e.live){this.set(e.name,t);return}this.edits.set(e,t),this.refresh(),this.edited()}field(e,t,n){if(e.type==="choice"){let o=x("select",{"aria-label":e.name});for(let a of e.choices)o.append(x("option",{value:a},a));return o.value=String(t),o.addEventListener("change",()=>{o.blur(),this.take(e,o.value)}),o}if(e.type==="boolean"){let o=x("input",{type:"checkbox","aria-label":e.name});return o.checked=t===!0,o.addEventListener("change",()=>{o.blur(),this.take(e,o.checked)}),o}let s=e.type==="text",r=x("input",{"aria-label":e.name,inputmode:s?"text":"decimal",size:"8"});return r.value=s?String(t):Qr(t),r.addEventListener("change",()=>{let o=bx(e,r.value),a="why"in o;r.setAttribute("aria-invalid",String(a)),n.textContent=a?o.why:"",a||this.take(e,o.value)}),r.addEventListener("keydown",o=>{o.key==="Enter"&&r.blur()}),r}};var Ad=class{constructor(e,t){this.call=t;this.table=new Ed(this.edits,e,()=>{this.count()}),this.element.append(x("div",{class:"parameters-bar"},x("div",{class:"parameters-tools"},this.table.filter,this.save,this.restore),this.message,this.question),this.table.element),this.save.addEventListener("click",()=>{this.ask("parameters_save",this.edits.wanted(this.all))}),this.restore.addEventListener("click",()=>{this.ask("parameters_restore",{})})}call;element=x("div",{class:"parameters",tabindex:"0"});save=x("button",{type:"button",class:"control",id:"parameters-save"},"Save …");restore=x("button",{type:"button",class:"control",id:"parameters-restore",hidden:""},"Undo the last save …");message=x("p",{class:"parameters-message",role:"status"});question=x("section",{class:"parameters-question",id:"parameters-question","aria-label":"Difference",hidden:""});edits=new Td;table;store;mayCommand=!1;compared=-1;busy=!1;show(e,t,n){this.store=e,this.mayCommand=t&&n,this.count(),this.table.show(e);let s=e.received["/parameter"]??0;this.mayCommand&&s>0&&s!==this.compared&&(this.compared=s,this.compare())}get all(){return this.store?.get("/parameter")?.parameters??[]}count(){let e=this.edits.names.length;Ce(this.save,e===0?"Save …":`Save … (${e})`),this.save.disabled=this.restore.disabled=!this.mayCommand||this.busy}async compare(){try{let e=await this.call("parameters_save",{check:!0,...this.edits.inForce(this.all)});this.edits.compared(e),this.restore.hidden=!e.may_restore,this.table.refresh()}catch(e){this.say(e)}}async ask(e,t){let n=await this.request(e,{...t,check:!0});if(n===void 0)return;if(n.differences.length===0){this.say(`${n.file} has these values already.`);return}let s=e==="parameters_restore",r=new Map(n.differences.map(({name:c})=>[c,!0])),o=x("button",{type:"button",class:"control",id:"parameters-write"},s?"Undo it":`Write ${n.file}`),a=x("button",{type:"button",class:"control",id:"parameters-cancel"},"Cancel");o.addEventListener("click",()=>{let c=Object.fromEntries(Object.entries(t).filter(([h])=>r.get(h)===!0));this.write(e,c)}),a.addEventListener("click",()=>{this.question.hidden=!0});let l=c=>this.difference(c,s?void 0:h=>{r.set(c.name,h),o.disabled=![...r.values()].includes(!0)});this.question.replaceChildren(x("p",{},s?`${n.file} will get its previous values:`:`${n.file} will change:`),x("ul",{},...n.differences.map(l)),x("div",{class:"parameters-tools"},o,a)),this.say(""),this.question.hidden=!1,o.focus()}difference({name:e,before:t,after:n},s){let r=[x("strong",{},e),x("del",{},t),x("ins",{},n)];if(s===void 0)return x("li",{},...r);let o=x("input",{type:"checkbox","aria-label":`Save ${e}`});return o.checked=!0,o.addEventListener("change",()=>{s(o.checked)}),x("li",{},x("label",{},o,...r))}async write(e,t){let n=await this.request(e,t);if(n===void 0)return;this.question.hidden=!0;for(let r of Object.keys(t))this.edits.drop(r);let s=n.differences.some(({name:r})=>this.all.find(o=>o.name===r)?.live!==!0||e==="parameters_restore");this.say(`${n.file} is saved${s?"; the running daemon keeps its values until it is started again":""}.`),await this.compare(),this.count()}async request(e,t){this.busy=!0,this.count();try{return await this.call(e,t)}catch(n){this.question.hidden=!0,this.say(n);return}finally{this.busy=!1,this.count()}}say(e){Ce(this.message,Ot(e))}};var bR=12,Cd=class{constructor(e,t,n){this.world=e;this.yaw_rad=t;this.done=n;let s=document.createElementNS("http://www.w3.org/2000/svg","svg");s.append(this.arrow),this.element.append(s),this.element.addEventListener("pointerdown",r=>{r.isPrimary&&(this.element.setPointerCapture(r.pointerId),this.from=this.at(r),this.draw(this.from))}),this.element.addEventListener("pointermove",r=>{this.from!==void 0&&this.draw(this.at(r))}),this.element.addEventListener("pointercancel",()=>{this.from=void 0}),this.element.addEventListener("pointerup",r=>{this.finish(this.at(r))})}world;yaw_rad;done;element=x("div",{class:"placing",hidden:""});arrow=document.createElementNS("http://www.w3.org/2000/svg","line");from;show(e){this.element.hidden=!e,this.from=void 0,this.arrow.style.display="none"}at(e){let t=this.element.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}draw(e){let t=this.from??e;this.arrow.style.display="";for(let[n,s]of[["x1",t.x],["y1",t.y],["x2",e.x],["y2",e.y]])$e(this.arrow,n,s.toFixed(1))}finish(e){let t=this.from;if(this.from=void 0,t===void 0)return;let n=this.world(t),s=this.world(e);if(n===void 0||s===void 0){this.done(void 0);return}let o=Math.hypot(e.x-t.x,e.y-t.y)>=bR?Math.atan2(s.y-n.y,s.x-n.x):this.yaw_rad();this.done({x_m:n.x,y_m:n.y,yaw_rad:o})}};var wR="uplot",SR="u-hz",MR="u-vt",TR="u-title",ER="u-wrap",AR="u-under",CR="u-over",PR="u-axis",no="u-off",RR="u-select",LR="u-cursor-x",IR="u-cursor-y",kR="u-cursor-pt",DR="u-legend",NR="u-live",OR="u-inline",UR="u-series",FR="u-marker",Mx="u-label",BR="u-value",$l="width",ql="height";var Tx="bottom",pa="left",Km="right",dg="#000",Ex=dg+"0",Zm="mousemove",Ax="mousedown",Jm="mouseup",Cx="mouseenter",Px="mouseleave",Rx="dblclick",zR="resize",VR="scroll",Lx="change",kd="dppxchange",fg="--",ba=typeof window<"u",ng=ba?document:null,ga=ba?window:null,HR=ba?navigator:null,Ct,Pd;function ig(){let i=devicePixelRatio;Ct!=i&&(Ct=i,Pd&&rg(Lx,Pd,ig),Pd=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),io(Lx,Pd,ig),ga.dispatchEvent(new CustomEvent(kd)))}function Ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function sg(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Kt(i,e,t){i.style[e]=t+"px"}function es(i,e,t,n){let s=ng.createElement(i);return e!=null&&Ei(s,e),t?.insertBefore(s,n),s}function Bi(i,e){return es("div",i,e)}var Ix=new WeakMap;function Es(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Ix.get(i);r!=o&&(i.style.transform=r,Ix.set(i,r),e<0||t<0||e>n||t>s?Ei(i,no):sg(i,no))}var kx=new WeakMap;function Dx(i,e,t){let n=e+t,s=kx.get(i);n!=s&&(kx.set(i,n),i.style.background=e,i.style.borderColor=t)}var Nx=new WeakMap;function Ox(i,e,t,n){let s=e+""+t,r=Nx.get(i);s!=r&&(Nx.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var pg={passive:!0},GR={...pg,capture:!0};function io(i,e,t,n){e.addEventListener(i,t,n?GR:pg)}function rg(i,e,t,n){e.removeEventListener(i,t,pg)}ba&&ig();function ts(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Ai((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function hb(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var ub=i=>i!=null,db=i=>i!=null&&i>0,Od=hb(ub),WR=hb(db);function XR(i,e,t,n=0,s=!1){let r=s?WR:Od,o=s?db:ub;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??zt,l??-zt]}function Ud(i,e,t,n){let s=Bx(i),r=Bx(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Zs:fb,a=s==1?Ai:zi,l=r==1?zi:Ai,c=a(o(In(i))),h=l(o(In(e))),u=_a(t,c),d=_a(t,h);return t==10&&(c<0&&(u=Vt(u,-c)),h<0&&(d=Vt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=_b(i,u),e=Fd(e,d)),[i,e]}function mg(i,e,t,n){let s=Ud(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var gg=.1,Ux={mode:3,pad:gg},Kl={pad:0,soft:null,mode:0},$R={min:Kl,max:Kl};function Dd(i,e,t,n){return Bd(t)?Fx(i,e,t):(Kl.pad=t,Kl.soft=n?0:null,Kl.mode=n?3:0,Fx(i,e,$R))}function Et(i,e){return i??e}function qR(i,e,t){for(e=Et(e,0),t=Et(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Fx(i,e,t){let n=t.min,s=t.max,r=Et(n.pad,0),o=Et(s.pad,0),a=Et(n.hard,-zt),l=Et(s.hard,zt),c=Et(n.soft,zt),h=Et(s.soft,-zt),u=Et(n.mode,0),d=Et(s.mode,0),f=e-i,g=Zs(f),y=ai(In(i),In(e)),p=Zs(y),m=In(p-g);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=zt&&(r=0),d==2&&h!=-zt&&(o=0)));let b=f||y||1e3,C=Zs(b),T=_a(10,Ai(C)),R=b*(f==0?i==0?.1:1:r),E=Vt(_b(i-R,T/10),24),v=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:zt,A=ai(a,E<v&&i>=v?v:ns(v,E)),z=b*(f==0?e==0?.1:1:o),N=Vt(Fd(e+z,T/10),24),D=e<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-zt,W=ns(l,N>D&&e<=D?D:ai(D,N));return A==W&&A==0&&(W=100),[A,W]}var YR=new Intl.NumberFormat(ba?HR.language:"en-US"),_g=i=>YR.format(i),Ci=Math,Id=Ci.PI,In=Ci.abs,Ai=Ci.floor,Ln=Ci.round,zi=Ci.ceil,ns=Ci.min,ai=Ci.max,_a=Ci.pow,Bx=Ci.sign,Zs=Ci.log10,fb=Ci.log2,KR=(i,e=1)=>Ci.sinh(i)*e,jm=(i,e=1)=>Ci.asinh(i/e),zt=1/0;function zx(i){return(Zs((i^i>>31)-(i>>31))|0)+1}function og(i,e,t){return ns(ai(i,e),t)}function pb(i){return typeof i=="function"}function St(i){return pb(i)?i:()=>i}var ZR=()=>{},mb=i=>i,gb=(i,e)=>e,JR=i=>null,Vx=i=>!0,Hx=(i,e)=>i==e,jR=/\.\d*?(?=9{6,}|0{6,})/gm,so=i=>{if(yb(i)||Tr.has(i))return i;let e=`${i}`,t=e.match(jR);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${so(s)}e${r}`}return Vt(i,n)};function eo(i,e){return so(Vt(so(i/e))*e)}function Fd(i,e){return so(zi(so(i/e))*e)}function _b(i,e){return so(Ai(so(i/e))*e)}function Vt(i,e=0){if(yb(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Ln(n)/t}var Tr=new Map;function vb(i){return((""+i).split(".")[1]||"").length}function Jl(i,e,t,n){let s=[],r=n.map(vb);for(let o=e;o<t;o++){let a=In(o),l=Vt(_a(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Vt(h,u);s.push(d),Tr.set(d,u)}}return s}var Zl={},vg=[],va=[null,null],Mr=Array.isArray,yb=Number.isInteger,QR=i=>i===void 0;function Gx(i){return typeof i=="string"}function Bd(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function e2(i){return i!=null&&typeof i=="object"}var t2=Object.getPrototypeOf(Uint8Array),xb="__proto__";function ya(i,e=Bd){let t;if(Mr(i)){let n=i.find(s=>s!=null);if(Mr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ya(i[s],e)}else t=i.slice()}else if(i instanceof t2)t=i.slice();else if(e(i)){t={};for(let n in i)n!=xb&&(t[n]=ya(i[n],e))}else t=i;return t}function bn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=xb&&(Bd(i[s])?bn(i[s],ya(n[s])):i[s]=ya(n[s]))}return i}var n2=0,i2=1,s2=2;function r2(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function o2(i,e){if(c2(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return h2(o[0])||(o=l2(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:i2,f=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(l[g]);y===null?d!=n2&&(u[p]=y,d==s2&&f.push(p)):u[p]=y}r2(u,f,s),n.push(u)}}return n}var a2=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function l2(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function c2(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function h2(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ai(1,Ai((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var bb=["January","February","March","April","May","June","July","August","September","October","November","December"],wb=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Sb(i){return i.slice(0,3)}var u2=wb.map(Sb),d2=bb.map(Sb),f2={MMMM:bb,MMM:d2,WWWW:wb,WWW:u2};function Xl(i){return(i<10?"0":"")+i}function p2(i){return(i<10?"00":i<100?"0":"")+i}var m2={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Xl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Xl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Xl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Xl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Xl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>p2(i.getMilliseconds())};function yg(i,e){e=e||f2;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?m2[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var g2=new Intl.DateTimeFormat().resolvedOptions().timeZone;function _2(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==g2?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Mb=i=>i%1==0,Nd=[1,2,2.5,5],v2=Jl(10,-32,0,Nd),Tb=Jl(10,0,32,Nd),y2=Tb.filter(Mb),to=v2.concat(Tb),xg=`
`,Eb="{YYYY}",Wx=xg+Eb,Ab="{M}/{D}",Yl=xg+Ab,Rd=Yl+"/{YY}",Cb="{aa}",x2="{h}:{mm}",ma=x2+Cb,Xx=xg+ma,$x=":{ss}",It=null;function Pb(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Jl(10,0,3,Nd).filter(Mb):Jl(10,-3,0,Nd)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Eb,It,It,It,It,It,It,1],[s*28,"{MMM}",Wx,It,It,It,It,It,1],[s,Ab,Wx,It,It,It,It,It,1],[n,"{h}"+Cb,Rd,It,Yl,It,It,It,1],[t,ma,Rd,It,Yl,It,It,It,1],[e,$x,Rd+" "+ma,It,Yl+" "+ma,It,Xx,It,1],[i,$x+".{fff}",Rd+" "+ma,It,Yl+" "+ma,It,Xx,It,1]];function h(u){return(d,f,g,y,p,m)=>{let b=[],C=p>=o,T=p>=r&&p<o,R=u(g),E=Vt(R*i,3),v=Qm(R.getFullYear(),C?0:R.getMonth(),T||C?1:R.getDate()),A=Vt(v*i,3);if(T||C){let z=T?p/r:0,N=C?p/o:0,D=E==A?E:Vt(Qm(v.getFullYear()+N,v.getMonth()+z,1)*i,3),W=new Date(Ln(D/i)),G=W.getFullYear(),I=W.getMonth();for(let F=0;D<=y;F++){let $=Qm(G+N*F,I+z*F,1),V=$-u(Vt($*i,3));D=Vt((+$+V)*i,3),D<=y&&b.push(D)}}else{let z=p>=s?s:p,N=Ai(g)-Ai(E),D=A+N+Fd(E-A,z);b.push(D);let W=u(D),G=W.getHours()+W.getMinutes()/t+W.getSeconds()/n,I=p/n,F=d.axes[f]._space,$=m/F;for(;D=Vt(D+p,i==1?0:3),!(D>y);)if(I>1){let V=Ai(Vt(G+I,6))%24,Q=u(D).getHours()-V;Q>1&&(Q=-1),D-=Q*n,G=(G+I)%24;let ie=b[b.length-1];Vt((D-ie)/p,3)*$>=.7&&b.push(D)}else b.push(D)}return b}}return[l,c,h]}var[b2,w2,S2]=Pb(1),[M2,T2,E2]=Pb(.001);Jl(2,-53,53,[1]);function qx(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Yx(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let y=i(g),p=y.getFullYear(),m=y.getMonth(),b=y.getDate(),C=y.getHours(),T=y.getMinutes(),R=y.getSeconds(),E=p!=l&&a[2]||m!=c&&a[3]||b!=h&&a[4]||C!=u&&a[5]||T!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=b,u=C,d=T,f=R,E(y)})}}function A2(i,e){let t=yg(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Qm(i,e,t){return new Date(i,e,t)}function Kx(i,e){return e(i)}var C2="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zx(i,e){return(t,n,s,r)=>r==null?fg:e(i(n))}function P2(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function R2(i,e){return i.series[e].fill(i,e)}var L2={show:!0,live:!0,isolate:!1,mount:ZR,markers:{show:!0,width:2,stroke:P2,fill:R2,dash:"solid"},idx:null,idxs:null,values:[]};function I2(i,e){let t=i.cursor.points,n=Bi(),s=t.size(i,e);Kt(n,$l,s),Kt(n,ql,s);let r=s/-2;Kt(n,"marginLeft",r),Kt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Kt(n,"borderWidth",o),n}function k2(i,e){let t=i.series[e].points;return t._fill||t._stroke}function D2(i,e){let t=i.series[e].points;return t._stroke||t._fill}function N2(i,e){return i.series[e].points.size}var eg=[0,0];function O2(i,e,t){return eg[0]=e,eg[1]=t,eg}function Ld(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function tg(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var U2={show:!0,x:!0,y:!0,lock:!1,move:O2,points:{one:!1,show:I2,size:N2,width:0,stroke:D2,fill:k2},bind:{mousedown:Ld,mouseup:Ld,click:Ld,dblclick:Ld,mousemove:tg,mouseleave:tg,mouseenter:tg},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Rb={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bg=bn({},Rb,{filter:gb}),Lb=bn({},bg,{size:10}),Ib=bn({},Rb,{show:!1}),wg='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',kb="bold "+wg,Db=1.5,Jx={show:!0,scale:"x",stroke:dg,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:kb,side:2,grid:bg,ticks:Lb,border:Ib,font:wg,lineGap:Db,rotate:0},F2="Value",B2="Time",jx={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function z2(i,e,t,n,s){return e.map(r=>r==null?"":_g(r))}function V2(i,e,t,n,s,r,o){let a=[],l=Tr.get(s)||0;t=o?t:Vt(Fd(t,s),l);for(let c=t;c<=n;c=Vt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ag(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Zs:fb,h=Ai(c(t));s=_a(l,h),l==10&&(s=to[ts(s,to)]);let u=t,d=s*l;l==10&&(d=to[ts(d,to)]);do a.push(u),u=u+s,l==10&&!Tr.has(u)&&(u=Vt(u,Tr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=to[ts(d,to)]));while(u<=n);return a}function H2(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ag(i,e,ai(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?ag(i,e,ai(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Nb=/./,G2=/[12357]/,W2=/[125]/,Qx=/1/,lg=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function X2(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Nb:l(7,o)-h>=c?G2:l(5,o)-h>=c?W2:Qx;if(u==Qx){let d=In(l(1,o)-h);if(d<c)return lg(e.slice().reverse(),a.distr,u,zi(c/d)).reverse()}return lg(e,a.distr,u,1)}function $2(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=In(l(1,o)-l(2,o));return c<a?lg(e.slice().reverse(),3,Nb,zi(a/c)).reverse():e}function q2(i,e,t,n){return n==null?fg:e==null?"":_g(e)}var eb={show:!0,scale:"y",stroke:dg,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:kb,side:3,grid:bg,ticks:Lb,border:Ib,font:wg,lineGap:Db,rotate:0};function Y2(i,e){let t=3+(i||1)*2;return Vt(t*e,3)}function K2(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=In(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var tb={scale:null,auto:!0,sorted:0,min:zt,max:-zt},Ob=(i,e,t,n,s)=>s,nb={show:!0,auto:!0,sorted:0,gaps:Ob,alpha:1,facets:[bn({},tb,{scale:"x"}),bn({},tb,{scale:"y"})]},ib={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ob,alpha:1,points:{show:K2,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function Z2(i,e,t,n,s){return t/10}var Ub={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},J2=bn({},Ub,{time:!1,ori:1}),sb={};function Fb(i,e){let t=sb[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(sb[i]=t)),t}var xa=1,cg=2;function ro(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,y,Vd,wa,Gd,zb,Hb):t(s,l,c,h,u,m,p,f,d,y,g,Hd,Sa,Tg,Vb,Gb)}function Sg(i,e){let t=0,n=0,s=Et(i.bands,vg);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function j2(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Js(i,e,t,n,s,r){return ro(i,e,(o,a,l,c,h,u,d,f,g,y,p)=>{let m=o.pxRound,b=c.dir*(c.ori==0?1:-1),C=c.ori==0?wa:Sa,T,R;b==1?(T=t,R=n):(T=n,R=t);let E=m(u(a[T],c,y,f)),v=m(d(l[T],h,p,g)),A=m(u(a[R],c,y,f)),z=m(d(r==1?h.max:h.min,h,p,g)),N=new Path2D(s);return C(N,A,z),C(N,E,z),C(N,E,v),N})}function zd(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Gd:Tg,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Q2(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Mg(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=f&&a.push([f,g])}return a}function rb(i){return i==0?mb:i==1?Ln:e=>eo(e,i)}function Bb(i){let e=i==0?Vd:Hd,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ns(c,a/2,l/2),h=ns(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Vd=(i,e,t)=>{i.moveTo(e,t)},Hd=(i,e,t)=>{i.moveTo(t,e)},wa=(i,e,t)=>{i.lineTo(e,t)},Sa=(i,e,t)=>{i.lineTo(t,e)},Gd=Bb(0),Tg=Bb(1),zb=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Vb=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Hb=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Gb=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Wb(i){return(e,t,n,s,r)=>ro(e,t,(o,a,l,c,h,u,d,f,g,y,p)=>{let{pxRound:m,points:b}=o,C,T;c.ori==0?(C=Vd,T=zb):(C=Hd,T=Vb);let R=Vt(b.width*Ct,3),E=(b.size-b.width)/2*Ct,v=Vt(E*2,3),A=new Path2D,z=new Path2D,{left:N,top:D,width:W,height:G}=e.bbox;Gd(z,N-v,D-v,W+v*2,G+v*2);let I=F=>{if(l[F]!=null){let $=m(u(a[F],c,y,f)),V=m(d(l[F],h,p,g));C(A,$+E,V),T(A,$,V,E,0,Id*2)}};if(r)r.forEach(I);else for(let F=n;F<=s;F++)I(F);return{stroke:R>0?A:null,fill:A,clip:z,flags:xa|cg}})}function Xb(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var eL=Xb(wa),tL=Xb(Sa);function $b(i){let e=Et(i?.alignGaps,0);return(t,n,s,r)=>ro(t,n,(o,a,l,c,h,u,d,f,g,y,p)=>{[s,r]=Od(l,s,r);let m=o.pxRound,b=G=>m(u(G,c,y,f)),C=G=>m(d(G,h,p,g)),T,R;c.ori==0?(T=wa,R=eL):(T=Sa,R=tL);let E=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},A=v.stroke,z=!1;if(r-s>=y*4){let G=ue=>t.posToVal(ue,c.key,!0),I=null,F=null,$,V,le,Z=b(a[E==1?s:r]),Q=b(a[s]),ie=b(a[r]),de=G(E==1?Q+1:ie-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let ee=a[ue],ge=(E==1?ee<de:ee>de)?Z:b(ee),ve=l[ue];ge==Z?ve!=null?(V=ve,I==null?(T(A,ge,C(V)),$=I=F=V):V<I?I=V:V>F&&(F=V)):ve===null&&(z=!0):(I!=null&&R(A,Z,C(I),C(F),C($),C(V)),ve!=null?(V=ve,T(A,ge,C(V)),I=F=$=V):(I=F=null,ve===null&&(z=!0)),Z=ge,de=G(Z+E))}I!=null&&I!=F&&le!=Z&&R(A,Z,C(I),C(F),C($),C(V))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let I=l[G];I===null?z=!0:I!=null&&T(A,b(a[G]),C(I))}let[D,W]=Sg(t,n);if(o.fill!=null||D!=0){let G=v.fill=new Path2D(A),I=o.fillTo(t,n,o.min,o.max,D),F=C(I),$=b(a[s]),V=b(a[r]);E==-1&&([V,$]=[$,V]),T(G,V,F),T(G,$,F)}if(!o.spanGaps){let G=[];z&&G.push(...Mg(a,l,s,r,E,b,e)),v.gaps=G=o.gaps(t,n,s,r,G),v.clip=zd(G,c.ori,f,g,y,p)}return W!=0&&(v.band=W==2?[Js(t,n,s,r,A,-1),Js(t,n,s,r,A,1)]:Js(t,n,s,r,A,W)),v})}function nL(i){let e=Et(i.align,1),t=Et(i.ascDesc,!1),n=Et(i.alignGaps,0),s=Et(i.extend,!1);return(r,o,a,l)=>ro(r,o,(c,h,u,d,f,g,y,p,m,b,C)=>{[a,l]=Od(u,a,l);let T=c.pxRound,{left:R,width:E}=r.bbox,v=Q=>T(g(Q,d,b,p)),A=Q=>T(y(Q,f,C,m)),z=d.ori==0?wa:Sa,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},D=N.stroke,W=d.dir*(d.ori==0?1:-1),G=A(u[W==1?a:l]),I=v(h[W==1?a:l]),F=I,$=I;s&&e==-1&&($=R,z(D,$,G)),z(D,I,G);for(let Q=W==1?a:l;Q>=a&&Q<=l;Q+=W){let ie=u[Q];if(ie==null)continue;let de=v(h[Q]),ue=A(ie);e==1?z(D,de,G):z(D,F,ue),z(D,de,ue),G=ue,F=de}let V=F;s&&e==1&&(V=R+E,z(D,V,G));let[le,Z]=Sg(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,le),de=A(ie);z(Q,V,de),z(Q,$,de)}if(!c.spanGaps){let Q=[];Q.push(...Mg(h,u,a,l,W,v,n));let ie=c.width*Ct/2,de=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=ue}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=zd(Q,d.ori,p,m,b,C)}return Z!=0&&(N.band=Z==2?[Js(r,o,a,l,D,-1),Js(r,o,a,l,D,1)]:Js(r,o,a,l,D,Z)),N})}function ob(i,e,t,n,s,r,o=zt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=In(i[l]-i[a]);h<c&&(c=h,o=In(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function iL(i){i=i||Zl;let e=Et(i.size,[.6,zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=St(s),o=1-e[0],a=Et(e[1],zt),l=Et(e[2],1),c=Et(i.disp,Zl),h=Et(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,y,p)=>ro(f,g,(m,b,C,T,R,E,v,A,z,N,D)=>{let W=m.pxRound,G=t,I=n*Ct,F=a*Ct,$=l*Ct,V,le;T.ori==0?[V,le]=r(f,g):[le,V]=r(f,g);let Z=T.dir*(T.ori==0?1:-1),Q=T.ori==0?Gd:Tg,ie=T.ori==0?h:(Re,Ze,ct,Me,Bt,We,Ye)=>{h(Re,Ze,ct,Bt,Me,Ye,We)},de=Et(f.bands,vg).find(Re=>Re.series[0]==g),ue=de!=null?de.dir:0,ee=m.fillTo(f,g,m.min,m.max,ue),me=W(v(ee,R,D,z)),ge,ve,_e,Ge=N,Je=W(m.width*Ct),Ue=!1,ot=null,ht=null,at=null,Zt=null;u!=null&&(Je==0||d!=null)&&(Ue=!0,ot=u.values(f,g,y,p),ht=new Map,new Set(ot).forEach(Re=>{Re!=null&&ht.set(Re,new Path2D)}),Je>0&&(at=d.values(f,g,y,p),Zt=new Map,new Set(at).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:Ht,size:fn}=c;if(Ht!=null&&fn!=null){G=1,b=Ht.values(f,g,y,p),Ht.unit==2&&(b=b.map(ct=>f.posToVal(A+ct*N,T.key,!0)));let Re=fn.values(f,g,y,p);fn.unit==2?ve=Re[0]*N:ve=E(Re[0],T,N,A)-E(0,T,N,A),Ge=ob(b,C,E,T,N,A,Ge),_e=Ge-ve+I}else Ge=ob(b,C,E,T,N,A,Ge),_e=Ge*o+I,ve=Ge-_e;_e<1&&(_e=0),Je>=ve/2&&(Je=0),_e<5&&(W=mb);let Ut=_e>0,Dn=Ge-_e-(Ut?Je:0);ve=W(og(Dn,$,F)),ge=(G==0?ve/2:G==Z?0:ve)-G*Z*((G==0?I/2:0)+(Ut?Je/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Tn=Ue?null:new Path2D,sn=null;if(de!=null)sn=f.data[de.series[1]];else{let{y0:Re,y1:Ze}=c;Re!=null&&Ze!=null&&(C=Ze.values(f,g,y,p),sn=Re.values(f,g,y,p))}let pn=V*ve,U=le*ve;for(let Re=Z==1?y:p;Re>=y&&Re<=p;Re+=Z){let Ze=C[Re];if(Ze==null)continue;if(sn!=null){let X=sn[Re]??0;if(Ze-X==0)continue;me=v(X,R,D,z)}let ct=T.distr!=2||c!=null?b[Re]:Re,Me=E(ct,T,N,A),Bt=v(Et(Ze,ee),R,D,z),We=W(Me-ge),Ye=W(ai(Bt,me)),P=W(ns(Bt,me)),w=Ye-P;if(Ze!=null){let X=Ze<0?U:pn,he=Ze<0?pn:U;Ue?(Je>0&&at[Re]!=null&&Q(Zt.get(at[Re]),We,P+Ai(Je/2),ve,ai(0,w-Je),X,he),ot[Re]!=null&&Q(ht.get(ot[Re]),We,P+Ai(Je/2),ve,ai(0,w-Je),X,he)):Q(Tn,We,P+Ai(Je/2),ve,ai(0,w-Je),X,he),ie(f,g,Re,We-Je/2,P,ve+Je,w)}}return Je>0?Mt.stroke=Ue?Zt:Tn:Ue||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=Ue?ht:Tn,Mt})}function sL(i,e){let t=Et(e?.alignGaps,0);return(n,s,r,o)=>ro(n,s,(a,l,c,h,u,d,f,g,y,p,m)=>{[r,o]=Od(c,r,o);let b=a.pxRound,C=V=>b(d(V,h,p,g)),T=V=>b(f(V,u,m,y)),R,E,v;h.ori==0?(R=Vd,v=wa,E=Hb):(R=Hd,v=Sa,E=Gb);let A=h.dir*(h.ori==0?1:-1),z=C(l[A==1?r:o]),N=z,D=[],W=[];for(let V=A==1?r:o;V>=r&&V<=o;V+=A)if(c[V]!=null){let Z=l[V],Q=C(Z);D.push(N=Q),W.push(T(c[V]))}let G={stroke:i(D,W,R,v,E,b),fill:null,clip:null,band:null,gaps:null,flags:xa},I=G.stroke,[F,$]=Sg(n,s);if(a.fill!=null||F!=0){let V=G.fill=new Path2D(I),le=a.fillTo(n,s,a.min,a.max,F),Z=T(le);v(V,N,Z),v(V,z,Z)}if(!a.spanGaps){let V=[];V.push(...Mg(l,c,r,o,A,C,t)),G.gaps=V=a.gaps(n,s,r,o,V),G.clip=zd(V,h.ori,g,y,p,m)}return $!=0&&(G.band=$==2?[Js(n,s,r,o,I,-1),Js(n,s,r,o,I,1)]:Js(n,s,r,o,I,$)),G})}function rL(i){return sL(oL,i)}function oL(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var hg=new Set;function ab(){for(let i of hg)i.syncRect(!0)}ba&&(io(zR,ga,ab),io(VR,ga,ab,!0),io(kd,ga,()=>{wn.pxRatio=Ct}));var aL=$b(),lL=Wb();function lb(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ug(r,o,e,t))}function cL(i,e){return i.map((t,n)=>n==0?{}:bn({},e,t))}function ug(i,e,t,n){return bn({},e==0?t:n,i)}function qb(i,e,t){return e==null?va:[e,t]}var hL=qb;function uL(i,e,t){return e==null?va:Dd(e,t,gg,!0)}function Yb(i,e,t,n){return e==null?va:Ud(e,t,i.scales[n].log,!1)}var dL=Yb;function Kb(i,e,t,n){return e==null?va:mg(e,t,i.scales[n].log,!1)}var fL=Kb;function pL(i,e,t,n,s){let r=ai(zx(i),zx(e)),o=e-i,a=ts(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Tr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function cb(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Ln((t=+s)*Ct))+"px"),[i,e,t]}function mL(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Vt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(i,e,t){let n={mode:Et(i.mode,1)},s=n.mode;function r(_,S,L,k){let H=S.valToPct(_);return k+L*(S.dir==-1?1-H:H)}function o(_,S,L,k){let H=S.valToPct(_);return k+L*(S.dir==-1?H:1-H)}function a(_,S,L,k){return S.ori==0?r(_,S,L,k):o(_,S,L,k)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Bi(wR);if(i.id!=null&&(c.id=i.id),Ei(c,i.class),i.title){let _=Bi(TR,c);_.textContent=i.title}let h=es("canvas"),u=n.ctx=h.getContext("2d"),d=Bi(ER,c);io("click",d,_=>{_.target===g&&(Wt!=yo||Jt!=xo)&&Wn.click(n,_)},!0);let f=n.under=Bi(AR,d);d.appendChild(h);let g=n.over=Bi(CR,d);i=ya(i);let y=+Et(i.pxAlign,1),p=rb(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,b=n.series=s==1?lb(i.series||[],jx,ib,!1):cL(i.series||[null],nb),C=n.axes=lb(i.axes||[],Jx,eb,!0),T=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=St(_.fill||null),_.dir=Et(_.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,v={axes:Is,series:vt},A=(i.drawOrder||["axes","series"]).map(_=>v[_]);function z(_){let S=_.distr==3?L=>Zs(L>0?L:_.clamp(n,L,_.min,_.max,_.key)):_.distr==4?L=>jm(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let k=S(L),{_min:H,_max:J}=_,ae=J-H;return(k-H)/ae}}function N(_){let S=T[_];if(S==null){let L=(i.scales||Zl)[_]||Zl;if(L.from!=null){N(L.from);let k=bn({},T[L.from],L,{key:_});k.valToPct=z(k),T[_]=k}else{S=T[_]=bn({},_==E?Ub:J2,L),S.key=_;let k=S.time,H=S.range,J=Mr(H);if((_!=E||s==2&&!k)&&(J&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Ux:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Ux:{mode:1,hard:H[1],soft:H[1]}},J=!1),!J&&Bd(H))){let ae=H;H=(fe,we,De)=>we==null?va:Dd(we,De,ae)}S.range=St(H||(k?hL:_==E?S.distr==3?dL:S.distr==4?fL:qb:S.distr==3?Yb:S.distr==4?Kb:uL)),S.auto=St(J?!1:S.auto),S.clamp=St(S.clamp||Z2),S._min=S._max=null,S.valToPct=z(S)}}}N("x"),N("y"),s==1&&b.forEach(_=>{N(_.scale)}),C.forEach(_=>{N(_.scale)});for(let _ in i.scales)N(_);let D=T[E],W=D.distr,G,I;D.ori==0?(Ei(c,SR),G=r,I=o):(Ei(c,MR),G=o,I=r);let F={};for(let _ in T){let S=T[_];(S.min!=null||S.max!=null)&&(F[_]={min:S.min,max:S.max},S.min=S.max=null)}let $=i.tzDate||(_=>new Date(Ln(_/m))),V=i.fmtDate||yg,le=m==1?S2($):E2($),Z=Yx($,qx(m==1?w2:T2,V)),Q=Zx($,Kx(C2,V)),ie=[],de=n.legend=bn({},L2,i.legend),ue=n.cursor=bn({},U2,{drag:{y:s==2}},i.cursor),ee=de.show,me=ue.show,ge=de.markers;de.idxs=ie,ge.width=St(ge.width),ge.dash=St(ge.dash),ge.stroke=St(ge.stroke),ge.fill=St(ge.fill);let ve,_e,Ge,Je=[],Ue=[],ot,ht=!1,at={};if(de.live){let _=b[1]?b[1].values:null;ht=_!=null,ot=ht?_(n,1,0):{_:0};for(let S in ot)at[S]=fg}if(ee)if(ve=es("table",DR,c),Ge=es("tbody",null,ve),de.mount(n,ve),ht){_e=es("thead",null,ve,Ge);let _=es("tr",null,_e);es("th",null,_);for(var Zt in ot)es("th",Mx,_).textContent=Zt}else Ei(ve,OR),de.live&&Ei(ve,NR);let Ht={show:!0},fn={show:!1};function Ut(_,S){if(S==0&&(ht||!de.live||s==2))return va;let L=[],k=es("tr",UR,Ge,Ge.childNodes[S]);Ei(k,_.class),_.show||Ei(k,no);let H=es("th",null,k);if(ge.show){let fe=Bi(FR,H);if(S>0){let we=ge.width(n,S);we&&(fe.style.border=we+"px "+ge.dash(n,S)+" "+ge.stroke(n,S)),fe.style.background=ge.fill(n,S)}}let J=Bi(Mx,H);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,S>0&&(ge.show||(J.style.color=_.width>0?ge.stroke(n,S):ge.fill(n,S)),Mt("click",H,fe=>{if(ue._lock)return;Qe(fe);let we=b.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let De=b.some((Ne,Fe)=>Fe>0&&Fe!=we&&Ne.show);b.forEach((Ne,Fe)=>{Fe>0&&hs(Fe,De?Fe==we?Ht:fn:Ht,!0,vn.setSeries)})}else hs(we,{show:!_.show},!0,vn.setSeries)},!1),et&&Mt(Cx,H,fe=>{ue._lock||(Qe(fe),hs(b.indexOf(_),wo,!0,vn.setSeries))},!1));for(var ae in ot){let fe=es("td",BR,k);fe.textContent="--",L.push(fe)}return[k,L]}let Dn=new Map;function Mt(_,S,L,k=!0){let H=Dn.get(S)||{},J=ue.bind[_](n,S,L,k);J&&(io(_,S,H[_]=J),Dn.set(S,H))}function Tn(_,S,L){let k=Dn.get(S)||{};for(let H in k)(_==null||H==_)&&(rg(H,S,k[H]),delete k[H]);_==null&&Dn.delete(S)}let sn=0,pn=0,U=0,Re=0,Ze=0,ct=0,Me=Ze,Bt=ct,We=U,Ye=Re,P=0,w=0,X=0,he=0;n.bbox={};let oe=!1,xe=!1,be=!1,te=!1,se=!1,pe=!1;function O(_,S,L){(L||_!=n.width||S!=n.height)&&re(_,S),pt(!1),be=!0,xe=!0,$n()}function re(_,S){n.width=sn=U=_,n.height=pn=Re=S,Ze=ct=0,Se(),Xe();let L=n.bbox;P=L.left=eo(Ze*Ct,.5),w=L.top=eo(ct*Ct,.5),X=L.width=eo(U*Ct,.5),he=L.height=eo(Re*Ct,.5)}let ne=3;function Te(){let _=!1,S=0;for(;!_;){S++;let L=go(S),k=cs(S);_=S==ne||L&&k,_||(re(n.width,n.height),xe=!0)}}function ye({width:_,height:S}){O(_,S)}n.setSize=ye;function Se(){let _=!1,S=!1,L=!1,k=!1;C.forEach((H,J)=>{if(H.show&&H._show){let{side:ae,_size:fe}=H,we=ae%2,De=H.label!=null?H.labelSize:0,Ne=fe+De;Ne>0&&(we?(U-=Ne,ae==3?(Ze+=Ne,k=!0):L=!0):(Re-=Ne,ae==0?(ct+=Ne,_=!0):S=!0))}}),as[0]=_,as[1]=L,as[2]=S,as[3]=k,U-=Vi[1]+Vi[3],Ze+=Vi[3],Re-=Vi[2]+Vi[0],ct+=Vi[0]}function Xe(){let _=Ze+U,S=ct+Re,L=Ze,k=ct;function H(J,ae){switch(J){case 1:return _+=ae,_-ae;case 2:return S+=ae,S-ae;case 3:return L-=ae,L+ae;case 0:return k-=ae,k+ae}}C.forEach((J,ae)=>{if(J.show&&J._show){let fe=J.side;J._pos=H(fe,J._size),J.label!=null&&(J._lpos=H(fe,J.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let L=_.prox=St(_.prox),k=_.bias??=0;ue.dataIdx=(H,J,ae,fe)=>{if(J==0)return ae;let we=ae,De=L(H,J,ae,fe)??zt,Ne=De>=0&&De<zt,Fe=D.ori==0?U:Re,lt=ue.left,At=e[0],Tt=e[J];if(S.has(Tt[ae])){we=null;let xt=null,je=null,qe;if(k==0||k==-1)for(qe=ae;xt==null&&qe-- >0;)S.has(Tt[qe])||(xt=qe);if(k==0||k==1)for(qe=ae;je==null&&qe++<Tt.length;)S.has(Tt[qe])||(je=qe);if(xt!=null||je!=null)if(Ne){let $t=xt==null?-1/0:G(At[xt],D,Fe,0),an=je==null?1/0:G(At[je],D,Fe,0),Fn=lt-$t,Ft=an-lt;Fn<=Ft?Fn<=De&&(we=xt):Ft<=De&&(we=je)}else we=je==null?xt:xt==null?je:ae-xt<=je-ae?xt:je}else Ne&&In(lt-G(At[ae],D,Fe,0))>De&&(we=null);return we}}let Qe=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let ce=ue.points;ce.show=St(ce.show),ce.size=St(ce.size),ce.stroke=St(ce.stroke),ce.width=St(ce.width),ce.fill=St(ce.fill);let Be=n.focus=bn({},i.focus||{alpha:.3},ue.focus),et=Be.prox>=0,Pe=et&&ce.one,ut=[],Gt=[],Zn=[];function La(_,S){let L=ce.show(n,S);if(L instanceof HTMLElement)return Ei(L,kR),Ei(L,_.class),Es(L,-10,-10,U,Re),g.insertBefore(L,ut[S]),L}function fo(_,S){if(s==1||S>0){let L=s==1&&T[_.scale].time,k=_.value;_.value=L?Gx(k)?Zx($,Kx(k,V)):k||Q:k||q2,_.label=_.label||(L?B2:F2)}if(Pe||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||aL||JR,_.fillTo=St(_.fillTo||j2),_.pxAlign=+Et(_.pxAlign,y),_.pxRound=rb(_.pxAlign),_.stroke=St(_.stroke||null),_.fill=St(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=Y2(ai(1,_.width),1),k=_.points=bn({},{size:L,width:ai(1,L*.2),stroke:_.stroke,space:L*2,paths:lL,_stroke:null,_fill:null},_.points);k.show=St(k.show),k.filter=St(k.filter),k.fill=St(k.fill),k.stroke=St(k.stroke),k.paths=St(k.paths),k.pxAlign=_.pxAlign}if(ee){let L=Ut(_,S);Je.splice(S,0,L[0]),Ue.splice(S,0,L[1]),de.values.push(null)}if(me){ie.splice(S,0,null);let L=null;Pe?S==0&&(L=La(_,S)):S>0&&(L=La(_,S)),ut.splice(S,0,L),Gt.splice(S,0,0),Zn.splice(S,0,0)}Un("addSeries",S)}function Tf(_,S){S=S??b.length,_=s==1?ug(_,S,jx,ib):ug(_,S,{},nb),b.splice(S,0,_),fo(b[S],S)}n.addSeries=Tf;function oc(_){if(b.splice(_,1),ee){de.values.splice(_,1),Ue.splice(_,1);let S=Je.splice(_,1)[0];Tn(null,S.firstChild),S.remove()}me&&(ie.splice(_,1),ut.splice(_,1)[0].remove(),Gt.splice(_,1),Zn.splice(_,1)),Un("delSeries",_)}n.delSeries=oc;let as=[!1,!1,!1,!1];function Ps(_,S){if(_._show=_.show,_.show){let L=_.side%2,k=T[_.scale];k==null&&(_.scale=L?b[1].scale:E,k=T[_.scale]);let H=k.time;_.size=St(_.size),_.space=St(_.space),_.rotate=St(_.rotate),Mr(_.incrs)&&_.incrs.forEach(ae=>{!Tr.has(ae)&&Tr.set(ae,vb(ae))}),_.incrs=St(_.incrs||(k.distr==2?y2:H?m==1?b2:M2:to)),_.splits=St(_.splits||(H&&k.distr==1?le:k.distr==3?ag:k.distr==4?H2:V2)),_.stroke=St(_.stroke),_.grid.stroke=St(_.grid.stroke),_.ticks.stroke=St(_.ticks.stroke),_.border.stroke=St(_.border.stroke);let J=_.values;_.values=Mr(J)&&!Mr(J[0])?St(J):H?Mr(J)?Yx($,qx(J,V)):Gx(J)?A2($,J):J||Z:J||z2,_.filter=St(_.filter||(k.distr>=3&&k.log==10?X2:k.distr==3&&k.log==2?$2:gb)),_.font=cb(_.font),_.labelFont=cb(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(as[S]=!0,_._el=Bi(PR,d))}}function Rs(_,S,L,k){let[H,J,ae,fe]=L,we=S%2,De=0;return we==0&&(fe||J)&&(De=S==0&&!H||S==2&&!ae?Ln(Jx.size/3):0),we==1&&(H||ae)&&(De=S==1&&!J||S==3&&!fe?Ln(eb.size/2):0),De}let Ia=n.padding=(i.padding||[Rs,Rs,Rs,Rs]).map(_=>St(Et(_,Rs))),Vi=n._padding=Ia.map((_,S)=>_(n,S,as,0)),rn,hn=null,un=null,ls=s==1?b[0].idxs:null,mi=null,Qs=!1;function ka(_,S){if(e=_??[],n.data=n._data=e,s==2){rn=0;for(let L=1;L<b.length;L++)rn+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),mi=e[0],rn=mi.length;let L=e;if(W==2){L=e.slice();let k=L[0]=Array(rn);for(let H=0;H<rn;H++)k[H]=H}n._data=e=L}if(pt(!0),Un("setData"),W==2&&(be=!0),S!==!1){let L=D;L.auto(n,Qs)?Da():nr(E,L.min,L.max),te=te||ue.left>=0,pe=!0,$n()}}n.setData=ka;function Da(){Qs=!0;let _,S;s==1&&(rn>0?(hn=ls[0]=0,un=ls[1]=rn-1,_=e[0][hn],S=e[0][un],W==2?(_=hn,S=un):_==S&&(W==3?[_,S]=Ud(_,_,D.log,!1):W==4?[_,S]=mg(_,_,D.log,!1):D.time?S=_+Ln(86400/m):[_,S]=Dd(_,S,gg,!0))):(hn=ls[0]=_=null,un=ls[1]=S=null)),nr(E,_,S)}let po,er,mo,M,B,j,Y,K,Ee,Le;function Ae(_,S,L,k,H,J){_??=Ex,L??=vg,k??="butt",H??=Ex,J??="round",_!=po&&(u.strokeStyle=po=_),H!=er&&(u.fillStyle=er=H),S!=mo&&(u.lineWidth=mo=S),J!=B&&(u.lineJoin=B=J),k!=j&&(u.lineCap=j=k),L!=M&&u.setLineDash(M=L)}function Ie(_,S,L,k){S!=er&&(u.fillStyle=er=S),_!=Y&&(u.font=Y=_),L!=K&&(u.textAlign=K=L),k!=Ee&&(u.textBaseline=Ee=k)}function He(_,S,L,k,H=0){if(k.length>0&&_.auto(n,Qs)&&(S==null||S.min==null)){let J=Et(hn,0),ae=Et(un,k.length-1),fe=L.min==null?XR(k,J,ae,H,_.distr==3):[L.min,L.max];_.min=ns(_.min,L.min=fe[0]),_.max=ai(_.max,L.max=fe[1])}}let nt={min:null,max:null};function _t(){for(let k in T){let H=T[k];F[k]==null&&(H.min==null||F[E]!=null&&H.auto(n,Qs))&&(F[k]=nt)}for(let k in T){let H=T[k];F[k]==null&&H.from!=null&&F[H.from]!=null&&(F[k]=nt)}F[E]!=null&&pt(!0);let _={};for(let k in F){let H=F[k];if(H!=null){let J=_[k]=ya(T[k],e2);if(H.min!=null)bn(J,H);else if(k!=E||s==2)if(rn==0&&J.from==null){let ae=J.range(n,null,null,k);J.min=ae[0],J.max=ae[1]}else J.min=zt,J.max=-zt}}if(rn>0){b.forEach((k,H)=>{if(s==1){let J=k.scale,ae=F[J];if(ae==null)return;let fe=_[J];if(H==0){let we=fe.range(n,fe.min,fe.max,J);fe.min=we[0],fe.max=we[1],hn=ts(fe.min,e[0]),un=ts(fe.max,e[0]),un-hn>1&&(e[0][hn]<fe.min&&hn++,e[0][un]>fe.max&&un--),k.min=mi[hn],k.max=mi[un]}else k.show&&k.auto&&He(fe,ae,k,e[H],k.sorted);k.idxs[0]=hn,k.idxs[1]=un}else if(H>0&&k.show&&k.auto){let[J,ae]=k.facets,fe=J.scale,we=ae.scale,[De,Ne]=e[H],Fe=_[fe],lt=_[we];Fe!=null&&He(Fe,F[fe],J,De,J.sorted),lt!=null&&He(lt,F[we],ae,Ne,ae.sorted),k.min=ae.min,k.max=ae.max}});for(let k in _){let H=_[k],J=F[k];if(H.from==null&&(J==null||J.min==null)){let ae=H.range(n,H.min==zt?null:H.min,H.max==-zt?null:H.max,k);H.min=ae[0],H.max=ae[1]}}}for(let k in _){let H=_[k];if(H.from!=null){let J=_[H.from];if(J.min==null)H.min=H.max=null;else{let ae=H.range(n,J.min,J.max,k);H.min=ae[0],H.max=ae[1]}}}let S={},L=!1;for(let k in _){let H=_[k],J=T[k];if(J.min!=H.min||J.max!=H.max){J.min=H.min,J.max=H.max;let ae=J.distr;J._min=ae==3?Zs(J.min):ae==4?jm(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?Zs(J.max):ae==4?jm(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,S[k]=L=!0}}if(L){b.forEach((k,H)=>{s==2?H>0&&S.y&&(k._paths=null):S[k.scale]&&(k._paths=null)});for(let k in S)be=!0,Un("setScale",k);me&&ue.left>=0&&(te=pe=!0)}for(let k in F)F[k]=null}function ze(_){let S=og(hn-1,0,rn-1),L=og(un+1,0,rn-1);for(;_[S]==null&&S>0;)S--;for(;_[L]==null&&L<rn-1;)L++;return[S,L]}function vt(){if(rn>0){let _=b.some(S=>S._focus)&&Le!=Be.alpha;_&&(u.globalAlpha=Le=Be.alpha),b.forEach((S,L)=>{if(L>0&&S.show&&(tn(L,!1),tn(L,!0),S._paths==null)){let k=Le;Le!=S.alpha&&(u.globalAlpha=Le=S.alpha);let H=s==2?[0,e[L][0].length-1]:ze(e[L]);S._paths=S.paths(n,L,H[0],H[1]),Le!=k&&(u.globalAlpha=Le=k)}}),b.forEach((S,L)=>{if(L>0&&S.show){let k=Le;Le!=S.alpha&&(u.globalAlpha=Le=S.alpha),S._paths!=null&&kt(L,!1);{let H=S._paths!=null?S._paths.gaps:null,J=S.points.show(n,L,hn,un,H),ae=S.points.filter(n,L,J,H);(J||ae)&&(S.points._paths=S.points.paths(n,L,hn,un,ae),kt(L,!0))}Le!=k&&(u.globalAlpha=Le=k),Un("drawSeries",L)}}),_&&(u.globalAlpha=Le=1)}}function tn(_,S){let L=S?b[_].points:b[_];L._stroke=L.stroke(n,_),L._fill=L.fill(n,_)}function kt(_,S){let L=S?b[_].points:b[_],{stroke:k,fill:H,clip:J,flags:ae,_stroke:fe=L._stroke,_fill:we=L._fill,_width:De=L.width}=L._paths;De=Vt(De*Ct,3);let Ne=null,Fe=De%2/2;S&&we==null&&(we=De>0?"#fff":fe);let lt=L.pxAlign==1&&Fe>0;if(lt&&u.translate(Fe,Fe),!S){let At=P-De/2,Tt=w-De/2,xt=X+De,je=he+De;Ne=new Path2D,Ne.rect(At,Tt,xt,je)}S?Oe(fe,De,L.dash,L.cap,we,k,H,ae,J):Dt(_,fe,De,L.dash,L.cap,we,k,H,ae,Ne,J),lt&&u.translate(-Fe,-Fe)}function Dt(_,S,L,k,H,J,ae,fe,we,De,Ne){let Fe=!1;we!=0&&R.forEach((lt,At)=>{if(lt.series[0]==_){let Tt=b[lt.series[1]],xt=e[lt.series[1]],je=(Tt._paths||Zl).band;Mr(je)&&(je=lt.dir==1?je[0]:je[1]);let qe,$t=null;Tt.show&&je&&qR(xt,hn,un)?($t=lt.fill(n,At)||J,qe=Tt._paths.clip):je=null,Oe(S,L,k,H,$t,ae,fe,we,De,Ne,qe,je),Fe=!0}}),Fe||Oe(S,L,k,H,J,ae,fe,we,De,Ne)}let En=xa|cg;function Oe(_,S,L,k,H,J,ae,fe,we,De,Ne,Fe){Ae(_,S,L,k,H),(we||De||Fe)&&(u.save(),we&&u.clip(we),De&&u.clip(De)),Fe?(fe&En)==En?(u.clip(Fe),Ne&&u.clip(Ne),bt(H,ae),mn(_,J,S)):fe&cg?(bt(H,ae),u.clip(Fe),mn(_,J,S)):fe&xa&&(u.save(),u.clip(Fe),Ne&&u.clip(Ne),bt(H,ae),u.restore(),mn(_,J,S)):(bt(H,ae),mn(_,J,S)),(we||De||Fe)&&u.restore()}function mn(_,S,L){L>0&&(S instanceof Map?S.forEach((k,H)=>{u.strokeStyle=po=H,u.stroke(k)}):S!=null&&_&&u.stroke(S))}function bt(_,S){S instanceof Map?S.forEach((L,k)=>{u.fillStyle=er=k,u.fill(L)}):S!=null&&_&&u.fill(S)}function Ls(_,S,L,k){let H=C[_],J;if(k<=0)J=[0,0];else{let ae=H._space=H.space(n,_,S,L,k),fe=H._incrs=H.incrs(n,_,S,L,k,ae);J=pL(S,L,fe,k,ae)}return H._found=J}function gn(_,S,L,k,H,J,ae,fe,we,De){let Ne=ae%2/2;y==1&&u.translate(Ne,Ne),Ae(fe,ae,we,De,fe),u.beginPath();let Fe,lt,At,Tt,xt=H+(k==0||k==3?-J:J);L==0?(lt=H,Tt=xt):(Fe=H,At=xt);for(let je=0;je<_.length;je++)S[je]!=null&&(L==0?Fe=At=_[je]:lt=Tt=_[je],u.moveTo(Fe,lt),u.lineTo(At,Tt));u.stroke(),y==1&&u.translate(-Ne,-Ne)}function go(_){let S=!0;return C.forEach((L,k)=>{if(!L.show)return;let H=T[L.scale];if(H.min==null){L._show&&(S=!1,L._show=!1,pt(!1));return}else L._show||(S=!1,L._show=!0,pt(!1));let J=L.side,ae=J%2,{min:fe,max:we}=H,[De,Ne]=Ls(k,fe,we,ae==0?U:Re);if(Ne==0)return;let Fe=H.distr==2,lt=L._splits=L.splits(n,k,fe,we,De,Ne,Fe),At=H.distr==2?lt.map(qe=>mi[qe]):lt,Tt=H.distr==2?mi[lt[1]]-mi[lt[0]]:De,xt=L._values=L.values(n,L.filter(n,At,k,Ne,Tt),k,Ne,Tt);L._rotate=J==2?L.rotate(n,xt,k,Ne):0;let je=L._size;L._size=zi(L.size(n,xt,k,_)),je!=null&&L._size!=je&&(S=!1)}),S}function cs(_){let S=!0;return Ia.forEach((L,k)=>{let H=L(n,k,as,_);H!=Vi[k]&&(S=!1),Vi[k]=H}),S}function Is(){for(let _=0;_<C.length;_++){let S=C[_];if(!S.show||!S._show)continue;let L=S.side,k=L%2,H,J,ae=S.stroke(n,_),fe=L==0||L==3?-1:1,[we,De]=S._found;if(S.label!=null){let Qn=S.labelGap*fe,vi=Ln((S._lpos+Qn)*Ct);Ie(S.labelFont[0],ae,"center",L==2?"top":Tx),u.save(),k==1?(H=J=0,u.translate(vi,Ln(w+he/2)),u.rotate((L==3?-Id:Id)/2)):(H=Ln(P+X/2),J=vi);let Pr=pb(S.label)?S.label(n,_,we,De):S.label;u.fillText(Pr,H,J),u.restore()}if(De==0)continue;let Ne=T[S.scale],Fe=k==0?X:he,lt=k==0?P:w,At=S._splits,Tt=Ne.distr==2?At.map(Qn=>mi[Qn]):At,xt=Ne.distr==2?mi[At[1]]-mi[At[0]]:we,je=S.ticks,qe=S.border,$t=je.show?je.size:0,an=Ln($t*Ct),Fn=Ln((S.alignTo==2?S._size-$t-S.gap:S.gap)*Ct),Ft=S._rotate*-Id/180,ln=p(S._pos*Ct),gi=(an+Fn)*fe,jn=ln+gi;J=k==0?jn:0,H=k==1?jn:0;let Ri=S.font[0],Hi=S.align==1?pa:S.align==2?Km:Ft>0?pa:Ft<0?Km:k==0?"center":L==3?Km:pa,ds=Ft||k==1?"middle":L==2?"top":Tx;Ie(Ri,ae,Hi,ds);let _i=S.font[1]*S.lineGap,Li=At.map(Qn=>p(a(Qn,Ne,Fe,lt))),Gi=S._values;for(let Qn=0;Qn<Gi.length;Qn++){let vi=Gi[Qn];if(vi!=null){k==0?H=Li[Qn]:J=Li[Qn],vi=""+vi;let Pr=vi.indexOf(`
`)==-1?[vi]:vi.split(/\n/gm);for(let ei=0;ei<Pr.length;ei++){let b0=Pr[ei];Ft?(u.save(),u.translate(H,J+ei*_i),u.rotate(Ft),u.fillText(b0,0,0),u.restore()):u.fillText(b0,H,J+ei*_i)}}}je.show&&gn(Li,je.filter(n,Tt,_,De,xt),k,L,ln,an,Vt(je.width*Ct,3),je.stroke(n,_),je.dash,je.cap);let fs=S.grid;fs.show&&gn(Li,fs.filter(n,Tt,_,De,xt),k,k==0?2:1,k==0?w:P,k==0?he:X,Vt(fs.width*Ct,3),fs.stroke(n,_),fs.dash,fs.cap),qe.show&&gn([ln],[1],k==0?1:0,k==0?1:2,k==1?w:P,k==1?he:X,Vt(qe.width*Ct,3),qe.stroke(n,_),qe.dash,qe.cap)}Un("drawAxes")}function pt(_){b.forEach((S,L)=>{L>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(k=>{k.min=null,k.max=null})))})}let on=!1,Jn=!1,Nt=[];function _n(){Jn=!1;for(let _=0;_<Nt.length;_++)Un(...Nt[_]);Nt.length=0}function $n(){on||(a2(i0),on=!0)}function ac(_,S=!1){on=!0,Jn=S,_(n),i0(),S&&Nt.length>0&&queueMicrotask(_n)}n.batch=ac;function i0(){if(oe&&(_t(),oe=!1),be&&(Te(),be=!1),xe){if(Kt(f,pa,Ze),Kt(f,"top",ct),Kt(f,$l,U),Kt(f,ql,Re),Kt(g,pa,Ze),Kt(g,"top",ct),Kt(g,$l,U),Kt(g,ql,Re),Kt(d,$l,sn),Kt(d,ql,pn),h.width=Ln(sn*Ct),h.height=Ln(pn*Ct),C.forEach(({_el:_,_show:S,_size:L,_pos:k,side:H})=>{if(_!=null)if(S){let J=H===3||H===0?L:0,ae=H%2==1;Kt(_,ae?"left":"top",k-J),Kt(_,ae?"width":"height",L),Kt(_,ae?"top":"left",ae?ct:Ze),Kt(_,ae?"height":"width",ae?Re:U),sg(_,no)}else Ei(_,no)}),po=er=mo=B=j=Y=K=Ee=M=null,Le=1,Ua(!0),Ze!=Me||ct!=Bt||U!=We||Re!=Ye){pt(!1);let _=U/We,S=Re/Ye;if(me&&!te&&ue.left>=0){ue.left*=_,ue.top*=S,_o&&Es(_o,Ln(ue.left),0,U,Re),vo&&Es(vo,0,Ln(ue.top),U,Re);for(let L=0;L<ut.length;L++){let k=ut[L];k!=null&&(Gt[L]*=_,Zn[L]*=S,Es(k,zi(Gt[L]),zi(Zn[L]),U,Re))}}if(Xt.show&&!se&&Xt.left>=0&&Xt.width>0){Xt.left*=_,Xt.width*=_,Xt.top*=S,Xt.height*=S;for(let L in Lf)Kt(bo,L,Xt[L])}Me=Ze,Bt=ct,We=U,Ye=Re}Un("setSize"),xe=!1}sn>0&&pn>0&&(u.clearRect(0,0,h.width,h.height),Un("drawClear"),A.forEach(_=>_()),Un("draw")),Xt.show&&se&&(lc(Xt),se=!1),me&&te&&(Cr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(Pf(),pe=!1),l||(l=!0,n.status=1,Un("ready")),Qs=!1,on=!1}n.redraw=(_,S)=>{be=S||!1,_!==!1?nr(E,D.min,D.max):$n()};function Ef(_,S){let L=T[_];if(L.from==null){if(rn==0){let k=L.range(n,S.min,S.max,_);S.min=k[0],S.max=k[1]}if(S.min>S.max){let k=S.min;S.min=S.max,S.max=k}if(rn>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==E&&L.distr==2&&rn>0&&(S.min=ts(S.min,e[0]),S.max=ts(S.max,e[0]),S.min==S.max&&S.max++),F[_]=S,oe=!0,$n()}}n.setScale=Ef;let Af,Cf,_o,vo,s0,r0,yo,xo,o0,a0,Wt,Jt,tr=!1,Wn=ue.drag,Nn=Wn.x,On=Wn.y;me&&(ue.x&&(Af=Bi(LR,g)),ue.y&&(Cf=Bi(IR,g)),D.ori==0?(_o=Af,vo=Cf):(_o=Cf,vo=Af),Wt=ue.left,Jt=ue.top);let Xt=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),bo=Xt.show?Bi(RR,Xt.over?g:f):null;function lc(_,S){if(Xt.show){for(let L in _)Xt[L]=_[L],L in Lf&&Kt(bo,L,_[L]);S!==!1&&Un("setSelect")}}n.setSelect=lc;function eS(_){if(b[_].show)ee&&sg(Je[_],no);else if(ee&&Ei(Je[_],no),me){let L=Pe?ut[0]:ut[_];L!=null&&Es(L,-10,-10,U,Re)}}function nr(_,S,L){Ef(_,{min:S,max:L})}function hs(_,S,L,k){S.focus!=null&&rS(_),S.show!=null&&b.forEach((H,J)=>{J>0&&(_==J||_==null)&&(H.show=S.show,eS(J),s==2?(nr(H.facets[0].scale,null,null),nr(H.facets[1].scale,null,null)):nr(H.scale,null,null),$n())}),L!==!1&&Un("setSeries",_,S),k&&Fa("setSeries",n,_,S)}n.setSeries=hs;function tS(_,S){bn(R[_],S)}function nS(_,S){_.fill=St(_.fill||null),_.dir=Et(_.dir,-1),S=S??R.length,R.splice(S,0,_)}function iS(_){_==null?R.length=0:R.splice(_,1)}n.addBand=nS,n.setBand=tS,n.delBand=iS;function sS(_,S){b[_].alpha=S,me&&ut[_]!=null&&(ut[_].style.opacity=S),ee&&Je[_]&&(Je[_].style.opacity=S)}let ks,ir,Ar,wo={focus:!0};function rS(_){if(_!=Ar){let S=_==null,L=Be.alpha!=1;b.forEach((k,H)=>{if(s==1||H>0){let J=S||H==0||H==_;k._focus=S?null:J,L&&sS(H,J?1:Be.alpha)}}),Ar=_,L&&$n()}}ee&&et&&Mt(Px,ve,_=>{ue._lock||(Qe(_),Ar!=null&&hs(null,wo,!0,vn.setSeries))});function us(_,S,L){let k=T[S];L&&(_=_/Ct-(k.ori==1?ct:Ze));let H=U;k.ori==1&&(H=Re,_=H-_),k.dir==-1&&(_=H-_);let J=k._min,ae=k._max,fe=_/H,we=J+(ae-J)*fe,De=k.distr;return De==3?_a(10,we):De==4?KR(we,k.asinh):De==100?k.bwd(we):we}function oS(_,S){let L=us(_,E,S);return ts(L,e[0],hn,un)}n.valToIdx=_=>ts(_,e[0]),n.posToIdx=oS,n.posToVal=us,n.valToPos=(_,S,L)=>T[S].ori==0?r(_,T[S],L?X:U,L?P:0):o(_,T[S],L?he:Re,L?w:0),n.setCursor=(_,S,L)=>{Wt=_.left,Jt=_.top,Cr(null,S,L)};function l0(_,S){Kt(bo,pa,Xt.left=_),Kt(bo,$l,Xt.width=S)}function c0(_,S){Kt(bo,"top",Xt.top=_),Kt(bo,ql,Xt.height=S)}let Na=D.ori==0?l0:c0,Oa=D.ori==1?l0:c0;function aS(){if(ee&&de.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&ht)continue;let S=de.values[_],L=0;for(let k in S)Ue[_][L++].firstChild.nodeValue=S[k]}}function Pf(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((L,k)=>{ie[k]=L}):QR(_.idx)||ie.fill(_.idx),de.idx=ie[0]),ee&&de.live){for(let L=0;L<b.length;L++)(L>0||s==1&&!ht)&&lS(L,ie[L]);aS()}pe=!1,S!==!1&&Un("setLegend")}n.setLegend=Pf;function lS(_,S){let L=b[_],k=_==0&&W==2?mi:e[_],H;ht?H=L.values(n,_,S)??at:(H=L.value(n,S==null?null:k[S],_,S),H=H==null?at:{_:H}),de.values[_]=H}function Cr(_,S,L){o0=Wt,a0=Jt,[Wt,Jt]=ue.move(n,Wt,Jt),ue.left=Wt,ue.top=Jt,me&&(_o&&Es(_o,Ln(Wt),0,U,Re),vo&&Es(vo,0,Ln(Jt),U,Re));let k,H=hn>un;ks=zt,ir=null;let J=D.ori==0?U:Re,ae=D.ori==1?U:Re;if(Wt<0||rn==0||H){k=ue.idx=null;for(let fe=0;fe<b.length;fe++){let we=ut[fe];we!=null&&Es(we,-10,-10,U,Re)}et&&hs(null,wo,!0,_==null&&vn.setSeries),de.live&&(ie.fill(k),pe=!0)}else{let fe,we,De;s==1&&(fe=D.ori==0?Wt:Jt,we=us(fe,E),k=ue.idx=ts(we,e[0],hn,un),De=G(e[0][k],D,J,0));let Ne=-10,Fe=-10,lt=0,At=0,Tt=!0,xt="",je="";for(let qe=s==2?1:0;qe<b.length;qe++){let $t=b[qe],an=ie[qe],Fn=an==null?null:s==1?e[qe][an]:e[qe][1][an],Ft=ue.dataIdx(n,qe,k,we),ln=Ft==null?null:s==1?e[qe][Ft]:e[qe][1][Ft];if(pe=pe||ln!=Fn||Ft!=an,ie[qe]=Ft,qe>0&&$t.show){let gi=Ft==null?-10:Ft==k?De:G(s==1?e[0][Ft]:e[qe][0][Ft],D,J,0),jn=ln==null?-10:I(ln,s==1?T[$t.scale]:T[$t.facets[1].scale],ae,0);if(et&&ln!=null){let Ri=D.ori==1?Wt:Jt,Hi=In(Be.dist(n,qe,Ft,jn,Ri));if(Hi<ks){let ds=Be.bias;if(ds!=0){let _i=us(Ri,$t.scale),Li=ln>=0?1:-1,Gi=_i>=0?1:-1;Gi==Li&&(Gi==1?ds==1?ln>=_i:ln<=_i:ds==1?ln<=_i:ln>=_i)&&(ks=Hi,ir=qe)}else ks=Hi,ir=qe}}if(pe||Pe){let Ri,Hi;D.ori==0?(Ri=gi,Hi=jn):(Ri=jn,Hi=gi);let ds,_i,Li,Gi,fs,Qn,vi=!0,Pr=ce.bbox;if(Pr!=null){vi=!1;let ei=Pr(n,qe);Li=ei.left,Gi=ei.top,ds=ei.width,_i=ei.height}else Li=Ri,Gi=Hi,ds=_i=ce.size(n,qe);if(Qn=ce.fill(n,qe),fs=ce.stroke(n,qe),Pe)qe==ir&&ks<=Be.prox&&(Ne=Li,Fe=Gi,lt=ds,At=_i,Tt=vi,xt=Qn,je=fs);else{let ei=ut[qe];ei!=null&&(Gt[qe]=Li,Zn[qe]=Gi,Ox(ei,ds,_i,vi),Dx(ei,Qn,fs),Es(ei,zi(Li),zi(Gi),U,Re))}}}}if(Pe){let qe=Be.prox,$t=Ar==null?ks<=qe:ks>qe||ir!=Ar;if(pe||$t){let an=ut[0];an!=null&&(Gt[0]=Ne,Zn[0]=Fe,Ox(an,lt,At,Tt),Dx(an,xt,je),Es(an,zi(Ne),zi(Fe),U,Re))}}}if(Xt.show&&tr)if(_!=null){let[fe,we]=vn.scales,[De,Ne]=vn.match,[Fe,lt]=_.cursor.sync.scales,At=_.cursor.drag;if(Nn=At._x,On=At._y,Nn||On){let{left:Tt,top:xt,width:je,height:qe}=_.select,$t=_.scales[Fe].ori,an=_.posToVal,Fn,Ft,ln,gi,jn,Ri=fe!=null&&De(fe,Fe),Hi=we!=null&&Ne(we,lt);Ri&&Nn?($t==0?(Fn=Tt,Ft=je):(Fn=xt,Ft=qe),ln=T[fe],gi=G(an(Fn,Fe),ln,J,0),jn=G(an(Fn+Ft,Fe),ln,J,0),Na(ns(gi,jn),In(jn-gi))):Na(0,J),Hi&&On?($t==1?(Fn=Tt,Ft=je):(Fn=xt,Ft=qe),ln=T[we],gi=I(an(Fn,lt),ln,ae,0),jn=I(an(Fn+Ft,lt),ln,ae,0),Oa(ns(gi,jn),In(jn-gi))):Oa(0,ae)}else If()}else{let fe=In(o0-s0),we=In(a0-r0);if(D.ori==1){let lt=fe;fe=we,we=lt}Nn=Wn.x&&fe>=Wn.dist,On=Wn.y&&we>=Wn.dist;let De=Wn.uni;De!=null?Nn&&On&&(Nn=fe>=De,On=we>=De,!Nn&&!On&&(we>fe?On=!0:Nn=!0)):Wn.x&&Wn.y&&(Nn||On)&&(Nn=On=!0);let Ne,Fe;Nn&&(D.ori==0?(Ne=yo,Fe=Wt):(Ne=xo,Fe=Jt),Na(ns(Ne,Fe),In(Fe-Ne)),On||Oa(0,ae)),On&&(D.ori==1?(Ne=yo,Fe=Wt):(Ne=xo,Fe=Jt),Oa(ns(Ne,Fe),In(Fe-Ne)),Nn||Na(0,J)),!Nn&&!On&&(Na(0,0),Oa(0,0))}if(Wn._x=Nn,Wn._y=On,_==null){if(L){if(x0!=null){let[fe,we]=vn.scales;vn.values[0]=fe!=null?us(D.ori==0?Wt:Jt,fe):null,vn.values[1]=we!=null?us(D.ori==1?Wt:Jt,we):null}Fa(Zm,n,Wt,Jt,U,Re,k)}if(et){let fe=L&&vn.setSeries,we=Be.prox;Ar==null?ks<=we&&hs(ir,wo,!0,fe):ks>we?hs(null,wo,!0,fe):ir!=Ar&&hs(ir,wo,!0,fe)}}pe&&(de.idx=k,Pf()),S!==!1&&Un("setCursor")}let sr=null;Object.defineProperty(n,"rect",{get(){return sr==null&&Ua(!1),sr}});function Ua(_=!1){_?sr=null:(sr=g.getBoundingClientRect(),Un("syncRect",sr))}function h0(_,S,L,k,H,J,ae){ue._lock||tr&&_!=null&&_.movementX==0&&_.movementY==0||(Rf(_,S,L,k,H,J,ae,!1,_!=null),_!=null?Cr(null,!0,!0):Cr(S,!0,!1))}function Rf(_,S,L,k,H,J,ae,fe,we){if(sr==null&&Ua(!1),Qe(_),_!=null)L=_.clientX-sr.left,k=_.clientY-sr.top;else{if(L<0||k<0){Wt=-10,Jt=-10;return}let[De,Ne]=vn.scales,Fe=S.cursor.sync,[lt,At]=Fe.values,[Tt,xt]=Fe.scales,[je,qe]=vn.match,$t=S.axes[0].side%2==1,an=D.ori==0?U:Re,Fn=D.ori==1?U:Re,Ft=$t?J:H,ln=$t?H:J,gi=$t?k:L,jn=$t?L:k;if(Tt!=null?L=je(De,Tt)?a(lt,T[De],an,0):-10:L=an*(gi/Ft),xt!=null?k=qe(Ne,xt)?a(At,T[Ne],Fn,0):-10:k=Fn*(jn/ln),D.ori==1){let Ri=L;L=k,k=Ri}}we&&(S==null||S.cursor.event.type==Zm)&&((L<=1||L>=U-1)&&(L=eo(L,U)),(k<=1||k>=Re-1)&&(k=eo(k,Re))),fe?(s0=L,r0=k,[yo,xo]=ue.move(n,L,k)):(Wt=L,Jt=k)}let Lf={width:0,height:0,left:0,top:0};function If(){lc(Lf,!1)}let u0,d0,f0,p0;function m0(_,S,L,k,H,J,ae){tr=!0,Nn=On=Wn._x=Wn._y=!1,Rf(_,S,L,k,H,J,ae,!0,!1),_!=null&&(Mt(Jm,ng,g0,!1),Fa(Ax,n,yo,xo,U,Re,null));let{left:fe,top:we,width:De,height:Ne}=Xt;u0=fe,d0=we,f0=De,p0=Ne}function g0(_,S,L,k,H,J,ae){tr=Wn._x=Wn._y=!1,Rf(_,S,L,k,H,J,ae,!1,!0);let{left:fe,top:we,width:De,height:Ne}=Xt,Fe=De>0||Ne>0,lt=u0!=fe||d0!=we||f0!=De||p0!=Ne;if(Fe&&lt&&lc(Xt),Wn.setScale&&Fe&&lt){let At=fe,Tt=De,xt=we,je=Ne;if(D.ori==1&&(At=we,Tt=Ne,xt=fe,je=De),Nn&&nr(E,us(At,E),us(At+Tt,E)),On)for(let qe in T){let $t=T[qe];qe!=E&&$t.from==null&&$t.min!=zt&&nr(qe,us(xt+je,qe),us(xt,qe))}If()}else ue.lock&&(ue._lock=!ue._lock,Cr(S,!0,_!=null));_!=null&&(Tn(Jm,ng),Fa(Jm,n,Wt,Jt,U,Re,null))}function cS(_,S,L,k,H,J,ae){if(ue._lock)return;Qe(_);let fe=tr;if(tr){let we=!0,De=!0,Ne=10,Fe,lt;D.ori==0?(Fe=Nn,lt=On):(Fe=On,lt=Nn),Fe&&lt&&(we=Wt<=Ne||Wt>=U-Ne,De=Jt<=Ne||Jt>=Re-Ne),Fe&&we&&(Wt=Wt<yo?0:U),lt&&De&&(Jt=Jt<xo?0:Re),Cr(null,!0,!0),tr=!1}Wt=-10,Jt=-10,ie.fill(null),Cr(null,!0,!0),fe&&(tr=fe)}function _0(_,S,L,k,H,J,ae){ue._lock||(Qe(_),Da(),If(),_!=null&&Fa(Rx,n,Wt,Jt,U,Re,null))}function v0(){C.forEach(mL),O(n.width,n.height,!0)}io(kd,ga,v0);let So={};So.mousedown=m0,So.mousemove=h0,So.mouseup=g0,So.dblclick=_0,So.setSeries=(_,S,L,k)=>{let H=vn.match[2];L=H(n,S,L),L!=-1&&hs(L,k,!0,!1)},me&&(Mt(Ax,g,m0),Mt(Zm,g,h0),Mt(Cx,g,_=>{Qe(_),Ua(!1)}),Mt(Px,g,cS),Mt(Rx,g,_0),hg.add(n),n.syncRect=Ua);let cc=n.hooks=i.hooks||{};function Un(_,S,L){Jn?Nt.push([_,S,L]):_ in cc&&cc[_].forEach(k=>{k.call(null,n,S,L)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)cc[S]=(cc[S]||[]).concat(_.hooks[S])});let y0=(_,S,L)=>L,vn=bn({key:null,setSeries:!1,filters:{pub:Vx,sub:Vx},scales:[E,b[1]?b[1].scale:null],match:[Hx,Hx,y0],values:[null,null]},ue.sync);vn.match.length==2&&vn.match.push(y0),ue.sync=vn;let x0=vn.key,kf=Fb(x0);function Fa(_,S,L,k,H,J,ae){vn.filters.pub(_,S,L,k,H,J,ae)&&kf.pub(_,S,L,k,H,J,ae)}kf.sub(n);function hS(_,S,L,k,H,J,ae){vn.filters.sub(_,S,L,k,H,J,ae)&&So[_](null,S,L,k,H,J,ae)}n.pub=hS;function uS(){kf.unsub(n),hg.delete(n),Dn.clear(),rg(kd,ga,v0),c.remove(),ve?.remove(),Un("destroy")}n.destroy=uS;function Df(){Un("init",i,e),ka(e||i.data,!1),F[E]?Ef(E,F[E]):Da(),se=Xt.show&&(Xt.width>0||Xt.height>0),te=pe=!0,O(i.width,i.height)}return b.forEach(fo),C.forEach(Ps),t?t instanceof HTMLElement?(t.appendChild(c),Df()):t(n,Df):Df(),n}wn.assign=bn;wn.fmtNum=_g;wn.rangeNum=Dd;wn.rangeLog=Ud;wn.rangeAsinh=mg;wn.orient=ro;wn.pxRatio=Ct;wn.join=o2;wn.fmtDate=yg,wn.tzDate=_2;wn.sync=Fb;{wn.addGap=Q2,wn.clipGaps=zd;let i=wn.paths={points:Wb};i.linear=$b,i.stepped=nL,i.bars=iL,i.spline=rL}function gL(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));for(let t of[1,2,2.5,5])if(t*e>=i*(1-1e-9))return t*e;return 10*e}function jl(i,e,t){let n=Math.min(Number.isFinite(i)?i:t[0],t[0]),s=Math.max(Number.isFinite(e)?e:t[1],t[1]),r=gL((s-n)/4),o=r*1e-6;return[Math.floor((n+o)/r)*r,Math.ceil((s-o)/r)*r]}function Wd(i){let e=1/0,t=-1/0;for(let n of i)for(let s of n)s<e&&(e=s),s>t&&(t=s);return[e,t]}var Eg=new Map;function rt(i){let e=Eg.get(i);return e===void 0&&(e=getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim(),Eg.set(i,e)),e}function Zb(){Eg.clear()}var _L=44,vL=20,Jb="11px B612, sans-serif",Er=class{constructor(e){this.options=e;this.range=jl(NaN,NaN,e.soft);let t=x("div",{class:"plot-key"});for(let n of e.curves){let s=x("span",{class:"plot-value"});if(this.values.push(s),n.quiet===!0)continue;let r=x("i",{class:n.dash?"swatch dashed":"swatch"});r.style.color=`var(--${n.colour})`,t.append(x("span",{class:"plot-curve"},r,n.label,...n.nameOnly===!0?[]:[s]))}this.element=x("section",{class:"plot",id:`plot-${e.id}`,"aria-label":`${e.title}, ${e.unit}`},x("header",{},x("h2",{},e.title,x("span",{class:"plot-unit"},e.unit)),t),this.canvas),this.plot=new wn(this.uplotOptions(),e.curves.reduce(n=>[...n,[]],[[]]),this.canvas)}options;element;canvas=x("div",{class:"plot-canvas"});values=[];plot;end_s=1;from_s=0;range;resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e>0&&t>0&&(e!==this.plot.width||t!==this.plot.height)&&this.plot.setSize({width:e,height:t})}show(e,t){if(dt(this.element,"stale",e.stale("/estimate")),e.series.length===0)return;this.end_s=e.series.last_s,this.from_s=Math.max(this.end_s-t,0),this.end_s=Math.max(this.end_s,this.from_s+t);let n=e.series.since(this.from_s),s=o=>n[Vm[o]]??new Float64Array,r=this.options.curves.map(o=>s(o.column));this.range=jl(...Wd(r),this.options.soft),this.plot.setData([s("t_s"),...r]),this.figures()}figures(){let e=this.plot.data,t=this.plot.cursor.idx??(e[0]?.length??0)-1;this.values.forEach((n,s)=>{Ce(n,Ve(e[s+1]?.[t],this.options.decimals))})}uplotOptions(){let e={stroke:()=>rt("axis-grid"),width:1},t=this.options.times===!0;return{width:300,height:100,legend:{show:!1},padding:[6,10,t?0:4,0],cursor:{y:!1,points:{size:5},drag:{x:!1,y:!1},sync:{key:"time",setSeries:!1}},scales:{x:{time:!1,range:()=>[this.from_s,this.end_s]},y:{range:()=>this.range}},axes:[{show:!0,size:t?vL:0,stroke:()=>rt("dim"),font:Jb,grid:e,ticks:{show:!1},gap:4,space:48,values:(n,s)=>t?s.map(r=>Ve(r,0)):s.map(()=>"")},{size:_L,stroke:()=>rt("dim"),font:Jb,grid:e,ticks:{show:!1},gap:6,space:22,values:(n,s)=>s.map(r=>Ve(r,yL(s)))}],series:[{},...this.options.curves.map(n=>({stroke:()=>rt(n.colour),width:n.width??1.5,...n.dash?{dash:n.dash}:{},points:{show:!1}}))],hooks:{setCursor:[()=>{this.figures()}]}}}};function yL(i){let e=Math.abs((i[1]??1)-(i[0]??0));return Math.max(0,Math.min(3,Math.ceil(-Math.log10(e)-1e-9)+(/[^0]5/.test(e.toPrecision(2))?1:0)))}var xL={colour:"path",dash:[5,4],width:1.2},Xd=class{element=x("div",{class:"plots"});window_s=60;plots;truth;truthKnown=!1;constructor(){this.truth=new Er({id:"truth",title:"Error to truth",unit:"mm",decimals:1,soft:[0,10],curves:[{label:"model",column:"model_error_mm",colour:"model"},{label:"odom",column:"odometry_error_mm",colour:"odometry"},{label:"fused",column:"fused_error_mm",colour:"fused"}]}),this.truth.element.hidden=!0,this.plots=[new Er({id:"yaw",title:"Yaw",unit:"°",decimals:1,soft:[-10,10],curves:[{label:"truth",column:"truth_yaw_deg",colour:"truth",quiet:!0},{label:"model",column:"model_yaw_deg",colour:"model"},{label:"odom",column:"odometry_yaw_deg",colour:"odometry"},{label:"fused",column:"fused_yaw_deg",colour:"fused"},{label:"plan",column:"desired_yaw_deg",...xL,nameOnly:!0}]}),new Er({id:"error",title:"Tracking error",unit:"mm, °",decimals:1,soft:[-4,4],curves:[{label:"cross-track",column:"cross_track_mm",colour:"text"},{label:"heading °",column:"heading_error_deg",colour:"value"}]}),this.truth,new Er({id:"speed",title:"Track speed",unit:"m/s",decimals:3,soft:[-.05,.15],curves:[{label:"wanted left",column:"left_commanded_mps",colour:"left",dash:[3,3],width:1,quiet:!0},{label:"wanted right",column:"right_commanded_mps",colour:"right",dash:[3,3],width:1,quiet:!0},{label:"left",column:"left_mps",colour:"left"},{label:"right",column:"right_mps",colour:"right"}]}),new Er({id:"slip",title:"Slip",unit:"%",decimals:1,soft:[0,20],times:!0,curves:[{label:"fused left",column:"fused_slip_left_percent",colour:"left",dash:[3,3],width:1,quiet:!0},{label:"fused right",column:"fused_slip_right_percent",colour:"right",dash:[3,3],width:1,quiet:!0},{label:"left",column:"slip_left_percent",colour:"left"},{label:"right",column:"slip_right_percent",colour:"right"}]})],this.element.append(...this.plots.map(t=>t.element)),new ResizeObserver(()=>{for(let t of this.plots)t.resize()}).observe(this.element)}show(e){!this.truthKnown&&e.get("/estimate")?.truth&&(this.truthKnown=!0,this.truth.element.hidden=!1),dt(this.element,"with-truth",this.truthKnown);for(let t of this.plots)t.element.hidden||(t.resize(),t.show(e,this.window_s))}};var As=({name:i,run:e})=>i===""?e:i,jb=i=>i.files.find(({name:e})=>e==="report.html");var bL=/^compare-(.+)\.html$/;function ew(i,e,t){let n=x("input",{type:"checkbox","aria-label":`Compare ${As(i)}`});n.checked=e,n.disabled=i.active,n.addEventListener("change",()=>{t.choose(i,n.checked)});let s=x("tr",{"data-run":i.run},x("td",{class:"run-box"},n),x("td",{class:"run-what"},...wL(i)),x("td",{class:"run-when"},i.active?"recording":new Date(1e3*i.modified_unix_s).toLocaleString()),x("td",{class:"figure run-size"},Fi(i.bytes)),x("td",{},x("div",{class:"run-files"},...SL(i,t),...ML(i))));return i.active&&s.classList.add("active"),s}function wL(i){let e=[x("span",{class:"run-title"},As(i))],t=(n,s)=>{s!==""&&e.push(x("span",{class:n},s))};for(let n of i.tags.split(" "))t("run-tag",n);return i.keep&&t("run-tag","kept"),i.name!==""&&t("run-id",i.run),t("run-note",i.note),t("run-bad",i.note_error),e}function Qb(i,e,t,n){let s=x("button",{type:"button",class:"link run-deed","aria-label":e},i);return s.dataset.fixed=String(t),s.addEventListener("click",n),s}function SL(i,e){let t=As(i),n=i.files.find(({name:a})=>a==="run.mcap"),s=jb(i),r=[];if(s!==void 0)r.push(x("a",{class:"run-report",href:s.url,target:"_blank",rel:"noopener","aria-label":`Report of ${t}`},"report"));else if(n!==void 0){let a=Qb("make report",`Make the report of ${t}`,i.active,()=>{e.report(i)});a.classList.add("run-make"),r.push(a)}if(n!==void 0){let a=x("button",{type:"button",class:"link","aria-label":`Replay ${t}`},"replay");a.addEventListener("click",()=>{e.replay(n,i)}),r.push(a)}for(let{name:a,url:l}of i.files){let c=bL.exec(a)?.[1];c!==void 0&&r.push(x("a",{href:l,target:"_blank",rel:"noopener",title:`with ${c}`},"comparison"))}r.push(Qb("edit",`Name and note of ${t}`,!1,()=>{e.edit(i)}));let o=x("button",{type:"button",class:"link run-deed run-delete","aria-label":`Delete ${t}`},"delete");return o.dataset.fixed=String(i.active||n===void 0),hc(o,"really delete",()=>{e.remove(i)}),[...r,o]}function ML(i){let e=i.files.filter(({kind:n})=>n!=="note").map(({name:n,url:s,bytes:r})=>x("a",{href:s,download:"",title:Fi(r)},n)),t=e.length;return t===0?[]:(e.push(x("a",{class:"run-zip",href:`/runs/${i.run}.zip`,download:"","aria-label":`All files of ${As(i)} as a ZIP archive`},"all (zip)")),[x("details",{class:"run-more"},x("summary",{},t===1?"1 file":`${t} files`),...e)])}function tw(i,e,t){let n=x("input",{type:"text",name:"run-name",maxlength:"80",value:i.name}),s=x("input",{type:"text",name:"run-tags",maxlength:"200",value:i.tags,placeholder:"words"}),r=x("textarea",{name:"run-note",rows:"2",maxlength:"2000","aria-label":"Note"},i.note),o=x("input",{type:"checkbox",name:"run-keep"});o.checked=i.keep;let a=x("button",{type:"button",class:"control"},"Cancel");a.addEventListener("click",t);let l=x("form",{class:"run-form","aria-label":`Name and note of ${As(i)}`},x("label",{},"name ",n),x("label",{},"tags ",s),x("label",{},o," keep"),r,x("button",{type:"submit",class:"control run-save"},"Save"),a);return l.addEventListener("submit",c=>{c.preventDefault(),e({run:i.run,name:n.value.trim(),tags:s.value.trim().replace(/\s+/g," "),note:r.value.trim(),keep:o.checked})}),x("tr",{class:"run-edited"},x("td",{colspan:"5"},l))}var TL=5e3,Ag=2,$d=class{constructor(e,t,n=()=>performance.now()){this.ask=t;this.now=n;let s=["","run","recorded","size",""].map(r=>x("th",{scope:"col"},r));this.table=x("table",{},x("thead",{},x("tr",{},...s)),this.body),this.element.append(x("div",{class:"runs-bar"},this.room,this.compareButton,this.busy,this.message),this.table,this.empty),this.table.hidden=!0,this.compareButton.addEventListener("click",()=>{let[r,o]=(this.list?.runs??[]).filter(({run:a})=>this.chosen.has(a));r!==void 0&&o!==void 0&&this.make(`the comparison of ${As(r)} with ${As(o)}`,{name:"run_compare",request:{run:r.run,with:o.run}})}),this.actions={replay:e,report:r=>{this.make(`the report of ${As(r)}`,{name:"run_report",request:{run:r.run}})},edit:({run:r})=>{this.edit(r)},remove:({run:r})=>{this.change({name:"run_delete",request:{run:r}})},choose:({run:r},o)=>{o?this.chosen.add(r):this.chosen.delete(r),this.enable()}}}ask;now;element=x("div",{class:"runs",tabindex:"0"});body=x("tbody");empty=x("p",{class:"empty"});table;room=x("span",{class:"runs-room"});compareButton=x("button",{type:"button",class:"control",id:"compare"},"Compare");busy=x("span",{class:"runs-room"});message=x("p",{class:"runs-message",role:"status"});rows=new Map;chosen=new Set;actions;list;shown="";next_ms=0;mayCommand=!1;replayed="";editing;making;show(e,t){this.mayCommand=e,this.replayed=t,this.enable(),this.making!==void 0&&Ce(this.message,`Making ${this.making.what} … ${((this.now()-this.making.since_ms)/1e3).toFixed(0)} s`),!(this.now()<this.next_ms)&&(this.next_ms=this.now()+TL,this.load())}changed(){this.next_ms=0}enable(){let e=this.making!==void 0||(this.list?.making??"")!=="";this.compareButton.disabled=!this.mayCommand||e||this.chosen.size!==Ag,this.compareButton.title=this.chosen.size===Ag?"":"Choose two runs";for(let t of this.body.querySelectorAll(".run-deed")){let n=t.closest("tr")?.dataset.run,s=t.classList.contains("run-delete")&&n===this.replayed;t.disabled=!this.mayCommand||t.dataset.fixed==="true"||s||e&&t.classList.contains("run-make")}}async load(){try{let e=await fetch("/api/runs",{cache:"no-store"});if(!e.ok)throw new Error(e.statusText);let t=await e.text();if(t===this.shown)return;this.shown=t,this.build(this.list=JSON.parse(t))}catch{this.shown="",this.empty.hidden=!this.table.hidden,this.empty.textContent="The list of runs is not available now."}}build(e){let{runs:t,directory:n}=e,s=new Set(t.map(({run:a})=>a));for(let a of[...this.rows.keys()])s.has(a)||this.rows.delete(a);for(let a of[...this.chosen])s.has(a)||this.chosen.delete(a);let r=t.map(a=>this.row(a)),o=r.length===this.body.children.length;(!o||r.some((a,l)=>this.body.children[l]!==a))&&(o?r.forEach((a,l)=>{this.body.children[l]!==a&&this.body.children[l]?.replaceWith(a)}):this.body.replaceChildren(...r)),this.table.hidden=t.length===0,this.empty.hidden=t.length>0,this.empty.textContent=n?`No runs in ${n} yet. Press Record, or start tp100d with --record.`:"Nothing is recorded: start tp100d with --record DIR.",Ce(this.room,n===""?"":EL(e)),this.compareButton.hidden=t.length<Ag,Ce(this.busy,e.making===""||this.making!==void 0?"":`A report of ${e.making} is being made.`),this.enable()}row(e){let t=JSON.stringify(e),n=this.rows.get(e.run);if(n!==void 0&&(n.text===t||this.editing===e.run))return n.element;let s=ew(e,this.chosen.has(e.run),this.actions);return this.rows.set(e.run,{text:t,element:s}),s}edit(e){this.editing!==void 0&&this.endEdit();let t=this.list?.runs.find(o=>o.run===e),n=this.rows.get(e)?.element;if(t===void 0||n===void 0)return;let r=tw(t,o=>{this.change({name:"run_note",request:o}).then(a=>{a&&this.endEdit()})},()=>{this.endEdit()});n.replaceWith(r),this.editing=e,this.rows.set(e,{text:"",element:r}),r.querySelector("input")?.focus()}endEdit(){let e=this.editing;this.editing=void 0;let t=this.list?.runs.find(s=>s.run===e),n=e===void 0?void 0:this.rows.get(e);t===void 0||n===void 0||(this.rows.delete(t.run),n.element.replaceWith(this.row(t)),this.reload())}reload(){this.shown="",this.next_ms=0}async change(e){this.say("");try{return await this.ask(e),!0}catch(t){return this.fail(t),!1}finally{this.reload()}}async make(e,t){this.making={what:e,since_ms:this.now()},this.say(""),this.enable();try{let{url:n}=await this.ask(t),s=x("a",{href:n,target:"_blank",rel:"noopener",id:"made"},`Open ${e}`);this.making=void 0,this.message.replaceChildren(s),window.open(n,"_blank","noopener")}catch(n){this.making=void 0,this.fail(n,`${e} is not made: `)}finally{this.reload()}}fail(e,t=""){this.say(t+Ot(e),!0)}say(e,t=!1){Ce(this.message,e),dt(this.message,"bad",t)}};function EL({runs:i,bytes:e,quota_bytes:t,free_bytes:n}){let s=i.length===1?"1 run":`${i.length} runs`,r=t>0?` of at most ${Fi(t)}`:"";return`${s}, ${Fi(e)}${r} · ${Fi(n)} free`}function AL(i){let e=i.get("/state"),t=e?.faults.map(({name:n})=>n)??[];return[i.stale("/estimate"),e?.course,e?.run,e?.session,e?.stop.latched,...t].join(" ")}function CL(i,e){let t=i.get("/state");if(t===void 0)return e?"The recording is loading.":"Nothing is known of the robot yet.";let n=[],s=t.course===""?"No course":`Course ${t.course}`,r=t.pause_left_s===void 0?t.run:"paused";n.push(`${e?"Recording. ":""}${s}, robot ${t.robot}, ${r}.`);let o=i.get("/estimate"),a=i.pose;if(i.stale("/estimate"))n.push("Its pose is not known now.");else if(o!==void 0&&a!==void 0){let l=a.yaw_rad*180/Math.PI;if(n.push(`It is at x ${Ve(a.x_m,2)} m, y ${Ve(a.y_m,2)} m, heading ${Ve(l,0)} degrees.`),typeof t.length_m=="number"){let c=1e3*o.cross_track_m,h=Math.abs(c)<.5?"on the path":`${Ve(Math.abs(c),0)} mm to the ${c>0?"left":"right"} of the path`;n.push(`${Ve(t.progress_m,2)} of ${Ve(t.length_m,2)} m are driven, ${h}.`)}}t.stop.latched&&n.push("STOP is in force.");for(let{cause:l}of t.faults)n.push(`Fault: ${l}${/[.!?]$/.test(l)?"":"."}`);return n.join(" ")}var PL=1e4,qd=class{element=x("p",{class:"for-reading",id:"scene-words",role:"status"});key="";next_ms=-1/0;show(e,t,n){let s=`${String(t)} ${AL(e)}`;s===this.key&&n<this.next_ms||(this.key=s,this.next_ms=n+PL,Ce(this.element,CL(e,t)))}};var RL=["/estimate","/sample","/command","/slip","/link","/loop","/state"],ec=300,nw=.0399,LL=4,IL=4;function Pg(i){return RL.includes(i)}function Ma(i){return i.slice(0,Math.max(i.indexOf("."),0))}function kL(i,e){let t=[],n=(s,r,o)=>{if(typeof r=="number"||typeof r=="boolean")t.push(s);else{if(typeof r!="object"||r===null||o===IL)return;if(Array.isArray(r)&&r.length>LL)return;for(let[a,l]of Object.entries(r))(o>0||a!=="t_s")&&n(`${s}.${a}`,l,o+1)}};return n(i,e,0),t}function Cg(i,e){let t=e;for(let n of i.split(".").slice(1)){if(typeof t!="object"||t===null||!Object.hasOwn(t,n))return NaN;t=t[n]}return typeof t=="boolean"?Number(t):typeof t=="number"&&Number.isFinite(t)?t:NaN}function iw(i){return Cg(".t_s",i)}function Rg(i){let e=i.split(".").filter(r=>!/^\d+$/.test(r)).at(-1)??"",n=[[/_radps$/,"rad/s"],[/_mps2$/,"m/s²"],[/_mps$/,"m/s"],[/_degc$/,"°C"],[/_rad$/,"rad"],[/_hz$/,"Hz"],[/_ppm$/,"ppm"],[/_bytes_ps$/,"B/s"],[/_ms$/,"ms"],[/_us$/,"µs"],[/_m$/,"m"],[/_s$/,"s"],[/_v$/,"V"]].find(([r])=>r.test(e));return n!==void 0?n[1]:/_us\.(mean|p50|p99|p999|max)$/.test(i)?"µs":""}function sw(i,e){let t=e.toLowerCase().split(/\s+/);return i.filter(n=>t.every(s=>n.toLowerCase().includes(s)))}var Ql=class{constructor(e=Math.ceil(ec/nw),t=nw){this.capacity=e;this.interval_s=t}capacity;interval_s;series=new Map;known=new Set;seen={};get names(){return[...this.series.keys()]}get fields(){return[...this.known].sort()}of(e){return this.series.get(e)}choose(e){this.series.has(e)||this.series.set(e,new da(2,this.capacity,this.interval_s))}drop(e){this.series.delete(e)}receive(e,t){if(!Pg(e))return;let n=iw(t);if(Number.isFinite(n)){if(!(Math.abs(n-(this.seen[e]??-1/0))<1)){this.seen[e]=n;for(let s of kL(e,t))this.known.add(s)}for(let[s,r]of this.series)Ma(s)===e&&r.push([n,Cg(s,t)])}}before(e,t){this.series.get(e)?.before(t.map(n=>[iw(n),Cg(e,n)]))}};function rw(i){let e=new Map;i.forEach(({times:n,values:s},r)=>{n.forEach((o,a)=>{let l=o.toFixed(6),c=e.get(l)??i.map(()=>""),h=s[a]??NaN;Number.isFinite(h)&&(c[r]=String(h)),e.set(l,c)})});let t=[...e].sort(([n],[s])=>Number(n)-Number(s));return[["t_s",...i.map(({name:n})=>n)],...t.map(([n,s])=>[n,...s])].map(n=>n.join(",")).join(`
`)+`
`}var ow=["odometry","warn","fused","bad","value","run-5","run-2","run-3"],DL="11px B612, sans-serif",aw=170,Yd=class{constructor(e,t,n){this.names=e;this.unit=t;this.zoom=n;let s=x("div",{class:"plot-key"});e.forEach((r,o)=>{let a=x("i",{class:"swatch"});a.style.color=`var(--${lw(o)})`;let l=x("span",{class:"plot-value"});this.values.push(l),s.append(x("span",{class:"plot-curve"},a,r,l))}),this.element=x("section",{class:"plot signal-chart","aria-label":`${e.join(", ")} ${t}`},x("header",{},s,x("span",{class:"plot-unit"},t)),this.canvas),this.plot=new wn(this.options(),[[],...e.map(()=>[])],this.canvas)}names;unit;zoom;element;canvas=x("div",{class:"plot-canvas"});values=[];plot;range={from_s:0,to_s:1};now_s=NaN;y=[0,1];show(e,t,n){this.range=t,this.now_s=n;let s=[],r=[];for(let u of this.names){let[d=new Float64Array,f=new Float64Array]=e.of(u)?.since(t.from_s)??[],g=d.length;for(;g>1&&(d[g-2]??0)>t.to_s;)g--;s.push([d.subarray(0,g),f.subarray(0,g)]),r.push(f.subarray(0,g))}let[o,a]=Wd(r),c=a-o>0?0:Math.max(Math.abs(o)*.01,1e-6);this.y=jl(o-c,a+c,[o-c,a+c]);let{clientWidth:h}=this.canvas;h>0&&h!==this.plot.width&&this.plot.setSize({width:h,height:aw}),this.plot.setData(wn.join(s)),this.figures()}destroy(){this.plot.destroy(),this.element.remove()}get image(){return this.plot.ctx.canvas}colour(e){return rt(lw(e))}figures(){let e=this.plot.cursor.idx;this.names.forEach((t,n)=>{let s=this.plot.data[n+1]??[],r=e??s.length-1;for(;r>0&&(s[r]===void 0||s[r]===null);)r--;let o=s[r]??NaN,a=this.values[n];a!==void 0&&Ce(a,Number.isFinite(o)?Ve(o,NL(this.y)):Ve(null,0))})}options(){let e={stroke:()=>rt("dim"),font:DL,grid:{stroke:()=>rt("axis-grid"),width:1},ticks:{show:!1}};return{width:300,height:aw,legend:{show:!1},padding:[6,10,0,0],cursor:{y:!1,points:{size:5},drag:{x:!0,y:!1,setScale:!1},sync:{key:"signals",setSeries:!1}},scales:{x:{time:!1,range:()=>[this.range.from_s,this.range.to_s]},y:{range:()=>this.y}},axes:[{...e,size:20,gap:4,space:60,values:(t,n)=>n.map(s=>`${Ve(s,n.length>1&&(n[1]??0)-(n[0]??0)<1?2:0)} s`)},{...e,size:58,gap:6,space:24}],series:[{},...this.names.map((t,n)=>({stroke:()=>this.colour(n),width:1.5,points:{show:!1},spanGaps:!0}))],hooks:{setCursor:[()=>{this.figures()}],setSelect:[t=>{if(t.select.width<4)return;let n=t.posToVal(t.select.left,"x"),s=t.posToVal(t.select.left+t.select.width,"x");t.setSelect({left:0,top:0,width:0,height:0},!1),this.zoom({from_s:n,to_s:s})}],draw:[t=>{this.drawNow(t)}]}}}drawNow(e){if(!(this.now_s>this.range.from_s&&this.now_s<this.range.to_s))return;let t=e.valToPos(this.now_s,"x",!0);e.ctx.fillStyle=rt("dim"),e.ctx.fillRect(Math.round(t),e.bbox.top,1,e.bbox.height)}};function lw(i){return ow[i%ow.length]??"text"}function NL([i,e]){return Math.max(0,Math.min(6,3-Math.ceil(Math.log10(e-i||1))))}var uw="tp100.signals",Kd=8,OL=80,Lg=1,cw=60,UL=2e4,Zd=class{constructor(e){this.past=e;let t=tc("signals-in","+","Shorter time"),n=tc("signals-out","−","Longer time"),s=tc("signals-csv","CSV","Save the shown values as a table"),r=tc("signals-png","PNG","Save the diagrams as an image");this.element.append(this.chooser,x("div",{class:"signal-view"},x("div",{class:"signal-tools"},n,t,this.pauseButton,s,r),this.charts_)),this.search.addEventListener("input",()=>{this.showList()}),t.addEventListener("click",()=>{this.scale(.5)}),n.addEventListener("click",()=>{this.scale(2)}),this.pauseButton.addEventListener("click",()=>{let{from_s:o,to_s:a}=this.range,l=this.now_s>o?Math.min(a,this.now_s):a;this.fixed=this.fixed===void 0?{from_s:o,to_s:l}:void 0,this.draw()}),s.addEventListener("click",()=>{this.saveTable()}),r.addEventListener("click",()=>{this.saveImage()});for(let o of FL())this.choose(o);this.live.names.length>0&&innerWidth<700&&this.chooser.removeAttribute("open")}past;element=x("div",{class:"signals",tabindex:"0"});search=x("input",{type:"search",placeholder:"search fields","aria-label":"Search signals"});list=x("ul",{class:"signal-list"});chosen=x("summary",{});chooser=x("details",{class:"signal-chooser",open:""},this.chosen,this.search,this.list);pauseButton=tc("signals-pause","Pause","Pause or continue");charts_=x("div",{class:"signal-charts"});live=new Ql;signals=this.live;charts=[];window_s=cw;fixed;now_s=NaN;listed="";frames;receive(e,t){this.live.receive(e,t)}needs(e){return this.live.names.some(t=>Ma(t)===e)}look(e){let t=this.live.names;if(this.signals=this.live,this.fixed=void 0,e!==void 0){this.signals=new Ql(UL,0);for(let s of t)this.signals.choose(s);for(let{topic:s,message:r}of e)this.signals.receive(s,r);let n=(e.at(-1)?.time_s??0)-(e[0]?.time_s??0);this.window_s=Math.min(Math.max(n,Lg),ec)}else this.window_s=cw;this.frames=e,this.rebuild()}show(e){this.now_s=e.get("/estimate")?.t_s??NaN,this.showList(),this.draw()}get range(){if(this.fixed!==void 0)return this.fixed;let e=Number.isFinite(this.now_s)?this.now_s:0,t=this.signals.names.map(s=>this.signals.of(s)?.first_s??NaN).filter(Number.isFinite),n=Math.max(e-this.window_s,Math.min(e,...t));return{from_s:n,to_s:Math.max(e,n+this.window_s)}}scale(e){if(this.fixed===void 0)this.window_s=Math.min(Math.max(this.window_s*e,Lg),ec);else{let{from_s:t,to_s:n}=this.fixed,s=Math.min(Math.max((n-t)*e/2,Lg/20),ec),r=(t+n)/2;this.fixed={from_s:r-s,to_s:r+s}}this.draw()}choose(e){!Pg(Ma(e))||this.live.names.length>=Kd||(this.live.choose(e),this.signals!==this.live&&(this.signals.choose(e),this.signals.before(e,(this.frames??[]).filter(({topic:t})=>t===Ma(e)).map(({message:t})=>t))),this.past(Ma(e)).then(t=>{this.live.before(e,t)},()=>{}),this.rebuild())}drop(e){this.live.drop(e),this.signals.drop(e),this.rebuild()}rebuild(){let e=new Map;for(let t of this.live.names){let n=Rg(t);e.set(n,[...e.get(n)??[],t])}for(let t of this.charts)t.destroy();this.charts=[...e].map(([t,n])=>new Yd(n,t,s=>{this.fixed=s,this.draw()})),this.charts_.replaceChildren(...this.charts.length===0?[x("p",{class:"empty"},`Choose up to ${Kd} fields; those of one unit share a diagram. Drag over a diagram to see a part of the time.`)]:this.charts.map(t=>t.element)),localStorage.setItem(uw,JSON.stringify(this.live.names)),this.listed="",this.showList(),this.draw()}draw(){if(Ce(this.pauseButton,this.fixed===void 0?"Pause":"Go on"),$e(this.pauseButton,"aria-pressed",String(this.fixed!==void 0)),this.element.hidden)return;let e=this.range;for(let t of this.charts)t.show(this.signals,e,this.now_s)}showList(){let e=this.live.names,t=sw([...new Set([...this.live.fields,...this.signals.fields,...e])].sort(),this.search.value.trim()),n=[...t.filter(r=>e.includes(r)),...t.filter(r=>!e.includes(r))].slice(0,OL),s=`${n.join()} ${e.join()} ${t.length}`;s!==this.listed&&(this.listed=s,Ce(this.chosen,`Fields (${e.length} chosen)`),this.list.replaceChildren(...n.map(r=>this.item(r,e)),...t.length>n.length?[x("li",{class:"empty"},`${t.length-n.length} more: search`)]:[]))}item(e,t){let n=x("input",{type:"checkbox","aria-label":e});n.checked=t.includes(e),n.disabled=!n.checked&&t.length>=Kd,n.addEventListener("change",()=>{n.checked?this.choose(e):this.drop(e)});let s=Rg(e);return x("li",{},x("label",{},n,e,...s===""?[]:[x("span",{class:"plot-unit"},s)]))}saveTable(){let{from_s:e,to_s:t}=this.range,n=this.live.names.map(s=>{let[r=new Float64Array,o=new Float64Array]=this.signals.of(s)?.since(-1/0)??[],a=[...r.keys()].filter(l=>(r[l]??NaN)>=e&&(r[l]??NaN)<=t);return{name:s,times:Float64Array.from(a,l=>r[l]??NaN),values:Float64Array.from(a,l=>o[l]??NaN)}});hw("signals.csv",new Blob([rw(n)],{type:"text/csv"}))}saveImage(){let e=this.charts[0]?.image;if(e===void 0)return;let t=devicePixelRatio,n=22*t,s=x("canvas");s.width=e.width,s.height=this.charts.reduce((a,{image:l})=>a+l.height+n,0);let r=s.getContext("2d");if(r===null)return;r.fillStyle=rt("panel"),r.fillRect(0,0,s.width,s.height),r.font=`${12*t}px B612, sans-serif`,r.textBaseline="middle";let o=0;for(let a of this.charts){let l=8*t;a.names.forEach((c,h)=>{let u=`${c}${a.unit===""?"":` ${a.unit}`}`;r.fillStyle=a.colour(h),r.fillText(u,l,o+n/2),l+=r.measureText(u).width+16*t}),r.drawImage(a.image,0,o+n),o+=a.image.height+n}s.toBlob(a=>{a!==null&&hw("signals.png",a)})}};function tc(i,e,t){return x("button",{type:"button",class:"control",id:i,title:t},e)}function hw(i,e){let t=URL.createObjectURL(e);x("a",{href:t,download:i}).click(),setTimeout(()=>{URL.revokeObjectURL(t)},1e4)}function FL(){try{let i=JSON.parse(localStorage.getItem(uw)??"[]");return Array.isArray(i)?i.filter(e=>typeof e=="string").slice(0,Kd):[]}catch{return[]}}var Ta=class{element;value=x("span",{class:"chip-value"});detail=x("span",{class:"chip-detail"});constructor(e,t){this.element=x("div",{class:"chip",id:`chip-${e}`,"data-lamp":"none"},x("span",{class:"chip-label"},t),this.value,this.detail)}show(e,t,n,s=""){$e(this.element,"data-lamp",e),Ce(this.value,t),Ce(this.detail,n),$e(this.element,"title",s)}},BL={idle:"none",arming:"wait",running:"good",finished:"done",aborted:"bad",driving:"good"},Jd=class{element=x("div",{class:"chips"});run=new Ta("run","run");link=new Ta("link","link");loop=new Ta("loop","loop");viewers=new Ta("viewers","viewers");constructor(){this.run.element.setAttribute("role","status"),this.element.append(this.run.element,this.link.element,this.loop.element,this.viewers.element)}show(e,t){this.showRun(e),this.showLink(e,t);let n=e.get("/loop");if(!t||n===void 0||e.stale("/loop"))this.loop.show("none","–","");else{let o=n.overruns+n.missed;this.loop.show(o>0?"warn":"good",`${Ve(n.rate_hz,0)} Hz`,`p99.9 ${Yt(n.lateness_us.p999)}`,`${Rn(n.overruns)} overruns, ${Rn(n.missed)} missed cycles, paced by the ${n.pacing}`)}let s=e.get("/client"),r=s?.dropped_total??0;this.viewers.show(r>0?"warn":"none",t?Ve(s?.clients.length,0):"–",r>0?`${Rn(r)} dropped`:"",`Browsers and other clients of this daemon; ${Rn(r)} messages dropped because one was too slow`)}showRun(e){let t=e.get("/state");if(t===void 0||e.stale("/state")){this.run.show("none",t?.run??"–","stale");return}let n=ua(t.run);if(t.motors_on&&!n){this.run.show("bad",t.run,"motors on","The motors are on, though no run is under way");return}let s=typeof t.run_s=="number"?Ui(t.run_s):"",r=t.run==="driving"&&t.driver?t.driver.by:s,a=[t.watch===!0?"the robot stops when nobody watches":"",t.why_not_start].filter(l=>l!=="").join("; ");this.run.show(BL[t.run]??"none",t.run,r,a)}showLink(e,t){let n=e.get("/link");if(!t){this.link.show("bad","no daemon","");return}if(n===void 0||e.stale("/link")){this.link.show("warn","silent","");return}let s=n.lost_hz+n.bad_hz,r=`${n.kind??"unknown"} robot on ${n.port}, firmware ${n.firmware??"unknown"}; ${Rn(n.counters.lost)} samples lost, ${Rn(n.counters.crc_errors)} CRC errors, ${Rn(n.counters.reconnects)} reconnects`;if(n.session!=="ready"){let o=n.quality==="lost"||n.session==="closed"||n.session==="refused";this.link.show(o?"bad":"wait",n.session,n.port,r);return}this.link.show(n.quality==="good"?"good":"warn",`${Ve(n.samples_hz,0)} Hz`,s>.05?`${Ve(s,1)} bad/s`:`rtt ${Yt(n.round_trip_us)}`,r)}};var zL=3e3,jd=class{constructor(e,t="space or esc",n="STOP"){this.keys=t;this.element=x("button",{class:"stop",type:"button","data-state":"ready"});let s=x("span",{class:"stop-word"},li("stop"),n);this.element.append(s,this.line),this.line.setAttribute("role","status"),this.line.setAttribute("aria-live","assertive"),t!==""&&this.element.setAttribute("aria-keyshortcuts","Space Escape");let r=-1/0;this.element.addEventListener("pointerdown",o=>{r=o.timeStamp,e()}),this.element.addEventListener("click",o=>{(o.detail===0||o.timeStamp-r>zL)&&e()})}keys;element;line=x("span",{class:"stop-line"});show(e){$e(this.element,"data-state",e.kind),Ce(this.line,VL(e,this.keys))}};function VL(i,e){switch(i.kind){case"ready":return e;case"pending":return"sent…";case"not_acknowledged":return i.waiting?"not acknowledged · no link":"not acknowledged";case"stopped":{let t=i.by===""||i.took_ms!==null?"":` · ${i.by}`;return i.took_ms===null?`stopped${t}`:`robot stopped in ${Ve(i.took_ms,i.took_ms<100?1:0)} ms`}}}var HL=.6,GL=3;function dw(i,e){let n=(i.segments??[]).filter(({kind:s,from_m:r})=>s==="pivot"&&r>e).reduce((s,{angle_rad:r})=>s+Math.abs(r),0);return Math.max(i.length_m-e,0)/i.speed_mps+n/HL}function WL(i,e){if(i?.run!=="running"||e===void 0||!(e.length_m>0)||!(e.speed_mps>0)||(i.pause_left_s??0)>0)return;let t=dw(e,i.progress_m??0),n=dw(e,0)-t,s=i.run_s??0,r=n<GL?1:Math.min(Math.max(s/n,.7),2);return t*r}var Qd=class{element=x("section",{class:"timeline","aria-label":"Progress"});name=x("span",{class:"timeline-name"});strip=x("div",{class:"strip"});fill=x("i",{class:"strip-fill"});marks=x("div",{class:"strip-marks"});time=x("output",{class:"timeline-time"});left=x("output",{class:"timeline-left",title:"Estimated time left of the run"});progress=x("output",{class:"timeline-progress"});courseShown=-1;constructor(){this.strip.append(this.fill,this.marks),this.element.append(this.name,this.strip,this.progress,this.left,this.time)}show(e){let t=e.received["/course"]??0,n=e.get("/course");t!==this.courseShown&&(this.courseShown=t,this.build(n));let s=e.get("/state"),r=n?.length_m??0,o=s?.run==="idle"?0:e.get("/estimate")?.progress_m??0,l=`scaleX(${(r>0?Math.min(Math.max(o/r,0),1):0).toFixed(4)})`;this.fill.style.transform!==l&&(this.fill.style.transform=l),Ce(this.progress,r>0?`${Ve(o,2)} / ${Ve(r,2)} m`:"–");let c=WL(s,n);Ce(this.left,c===void 0?"":`${Ui(Math.ceil(c)).replace(/\.\d$/,"")} left`),Ce(this.time,Ui(s?.run_s??0)),dt(this.element,"stale",e.stale("/estimate"))}reset(){this.courseShown=-1}build(e){if(Ce(this.name,e===void 0||e.name===""?"no course":`course ${e.name}`),this.name.title=e?.description??"",this.marks.replaceChildren(),e===void 0||e.length_m<=0)return;let t=(n,s,r,o)=>{let a=x("i",{class:`mark ${r}`,title:o});a.style.left=`${(100*n/e.length_m).toFixed(2)}%`,a.style.width=`${(100*(s-n)/e.length_m).toFixed(2)}%`,this.marks.append(a)};for(let[n,s]of[["ramp",e.ramps],["block",e.blocks]])for(let r of s){let o=XL(e,r,"top_m"in r?r.top_m+.3:r.depth_m);o&&t(o[0],o[1],n,`${n}, ${Ve(1e3*r.height_m,0)} mm high`)}for(let n of e.disturbances)t(n.at_m,n.at_m+.01,"disturbance","disturbance")}};function XL(i,e,t){let n=i.path.filter(o=>Math.hypot(o.x_m-e.x_m,o.y_m-e.y_m)<=t/2),s=n[0],r=n.at(-1);return s&&r?[s.s_m,r.s_m]:void 0}var Ig=[1,2,4,.25],$L=.1,ef=class{element=x("section",{class:"transport","aria-label":"Recording"});name=x("span",{class:"transport-name"});play=x("button",{type:"button",id:"play","aria-label":"Play"});slider=x("input",{type:"range",id:"scrub",min:"0",step:"0.01","aria-label":"Position in the recording, seconds"});time=x("output",{class:"transport-time"});speed=x("button",{type:"button","aria-label":"Speed"},"1×");player;shownPlaying;constructor(e){let t=x("button",{type:"button",id:"live",class:"transport-live"},"back to live");this.element.append(this.name,this.play,this.slider,this.time,this.speed,t),this.element.hidden=!0,this.play.addEventListener("click",()=>this.player?.toggle()),this.slider.addEventListener("input",()=>{this.player!==void 0&&(this.player.playing=!1,this.player.show(Number(this.slider.value)))}),this.speed.addEventListener("click",()=>{this.player!==void 0&&(this.player.speed=Ig[(Ig.indexOf(this.player.speed)+1)%Ig.length]??1,Ce(this.speed,`${this.player.speed}×`))}),t.addEventListener("click",e)}loading(e,t){this.element.hidden=!1,Ce(this.name,`${e} · loading ${(100*t).toFixed(0)} %`)}open(e,t){this.player=t,this.element.hidden=!1,this.slider.max=t.duration_s.toFixed(2),Ce(this.speed,"1×"),Ce(this.name,e)}close(){this.player=void 0,this.element.hidden=!0}step(e){this.player!==void 0&&(this.player.playing=!1,this.player.show(this.player.position_s+e*$L))}show(){let e=this.player;if(e===void 0)return;let t=e.position_s.toFixed(2);this.slider.value!==t&&(this.slider.value=t),Ce(this.time,`${Ui(e.position_s)} / ${Ui(e.duration_s)}`),e.playing!==this.shownPlaying&&(this.shownPlaying=e.playing,this.play.replaceChildren(li(e.playing?"pause":"play")),$e(this.play,"aria-label",e.playing?"Pause":"Play"))}};var fw={type:"change"},Dg={type:"start"},mw={type:"end"},tf=new Dr,pw=new bi,qL=Math.cos(70*Fp.DEG2RAD),kn=new q,pi=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},kg=1e-6,nf=class extends gl{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:gr.ROTATE,MIDDLE:gr.DOLLY,RIGHT:gr.PAN},this.touches={ONE:_r.ROTATE,TWO:_r.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new si,this._lastTargetPosition=new q,this._quat=new si().setFromUnitVectors(e.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qo,this._sphericalDelta=new qo,this._scale=1,this._panOffset=new q,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new q,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=KL.bind(this),this._onPointerDown=YL.bind(this),this._onPointerUp=ZL.bind(this),this._onContextMenu=iI.bind(this),this._onMouseWheel=QL.bind(this),this._onKeyDown=eI.bind(this),this._onTouchStart=tI.bind(this),this._onTouchMove=nI.bind(this),this._onMouseDown=JL.bind(this),this._onMouseMove=jL.bind(this),this._interceptControlDown=sI.bind(this),this._interceptControlUp=rI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fw),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;kn.copy(t).sub(this.target),kn.applyQuaternion(this._quat),this._spherical.setFromVector3(kn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=pi:n>Math.PI&&(n-=pi),s<-Math.PI?s+=pi:s>Math.PI&&(s-=pi),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(kn.setFromSpherical(this._spherical),kn.applyQuaternion(this._quatInverse),t.copy(this.target).add(kn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=kn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=kn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(tf.origin.copy(this.object.position),tf.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(tf.direction))<qL?this.object.lookAt(this.target):(pw.setFromNormalAndCoplanarPoint(this.object.up,this.target),tf.intersectPlane(pw,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>kg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>kg||this._lastTargetPosition.distanceToSquared(this.target)>kg?(this.dispatchEvent(fw),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?pi/60*this.autoRotateSpeed*e:pi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){kn.setFromMatrixColumn(t,0),kn.multiplyScalar(-e),this._panOffset.add(kn)}_panUp(e,t){this.screenSpacePanning===!0?kn.setFromMatrixColumn(t,1):(kn.setFromMatrixColumn(t,0),kn.crossVectors(this.object.up,kn)),kn.multiplyScalar(e),this._panOffset.add(kn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;kn.copy(s).sub(this.target);let r=kn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/t.clientHeight),this._rotateUp(pi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/t.clientHeight),this._rotateUp(pi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function YL(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function KL(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function ZL(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(mw),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function JL(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case gr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pt.DOLLY;break;case gr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}break;case gr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Dg)}function jL(i){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function QL(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(i.preventDefault(),this.dispatchEvent(Dg),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(mw))}function eI(i){this.enabled!==!1&&this._handleKeyDown(i)}function tI(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case _r.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(i),this.state=Pt.TOUCH_ROTATE;break;case _r.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(i),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case _r.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pt.TOUCH_DOLLY_PAN;break;case _r.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Dg)}function nI(i){switch(this._trackPointer(i),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pt.NONE}}function iI(i){this.enabled!==!1&&i.preventDefault()}function sI(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function rI(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Ng=["chase","top","free"],gw=.52,oI=.29,_w=.16,aI=.5,lI=.18,sf=class{constructor(e,t){this.taken=t;this.camera.up.set(0,0,1),this.controls=new nf(this.camera,e),this.controls.enableDamping=!1,this.controls.maxPolarAngle=Math.PI/2-.02,this.controls.minDistance=.15,this.controls.maxDistance=8,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.mode_!=="free"&&(this.mode_="free",this.taken())}),this.controls.addEventListener("change",()=>{this.moved=!0}),this.overview()}taken;camera=new ni(40,1,.02,60);controls;mode_="free";heading_rad=0;box={min_x:-1,max_x:1,min_y:-1,max_y:1};moved=!0;wantedEye=new q;wantedTarget=new q;get mode(){return this.mode_}set(e){e==="free"&&this.mode_==="free"&&this.overview(),this.mode_=e,this.moved=!0}frame(e){this.box=e,this.mode_==="free"&&this.overview(),this.moved=!0}resize(e){this.camera.aspect=e,this.camera.updateProjectionMatrix(),this.mode_==="free"&&this.overview(),this.moved=!0}update(e,t){this.mode_==="chase"&&e!==void 0?this.chase(e,t):this.mode_==="top"&&this.above(t);let n=this.moved;return this.moved=!1,n}overview(){let{x:e,y:t,reach:n}=this.middle(),s=n*1.02;this.controls.target.set(e,t,0),this.camera.position.set(e+.16*s,t-.78*s,.72*s),this.controls.update()}chase(e,t){let n=Math.atan2(Math.sin(e.yaw_rad-this.heading_rad),Math.cos(e.yaw_rad-this.heading_rad));this.heading_rad+=n*(1-Math.exp(-t/aI));let s=Math.cos(this.heading_rad),r=Math.sin(this.heading_rad);this.wantedEye.set(e.x_m-gw*s,e.y_m-gw*r,e.z_m+oI),this.wantedTarget.set(e.x_m+_w*s,e.y_m+_w*r,e.z_m+.03),this.glide(t)}above(e){let{x:t,y:n,height:s}=this.middle();this.wantedEye.set(t,n-.002,s),this.wantedTarget.set(t,n,0),this.glide(e)}glide(e){let t=1-Math.exp(-e/lI),{position:n}=this.camera;n.distanceToSquared(this.wantedEye)+this.controls.target.distanceToSquared(this.wantedTarget)<1e-9||(n.lerp(this.wantedEye,t),this.controls.target.lerp(this.wantedTarget,t),this.camera.lookAt(this.controls.target),this.moved=!0)}middle(){let{min_x:e,max_x:t,min_y:n,max_y:s}=this.box,r=Math.tan(this.camera.fov*Math.PI/360),o=t-e+.25,a=s-n+.25,l=Math.max(a,o/this.camera.aspect)/(2*r),c=Math.max(o/this.camera.aspect,a*.85)/(2*r)+.3;return{x:(e+t)/2,y:(n+s)/2,reach:c,height:l}}};var rf=3e-4,Og=.001,Ea=class{poses=[];tracks_m=[];points=[];check(e){let t=e.get("/estimate"),n=oi.map(a=>t?.[a]??void 0),s=[e.leftTrack_m,e.rightTrack_m],r=oi.map(a=>e.path_histories[a].length);return this.poses.length>0&&n.every((a,l)=>cI(a,this.poses[l]))&&s.every((a,l)=>Math.abs(a-(this.tracks_m[l]??NaN))<rf)&&r.every((a,l)=>a===this.points[l])?!1:(this.poses=n,this.tracks_m=s,this.points=r,!0)}reset(){this.poses=[]}};function cI(i,e){return i===void 0||e===void 0?i===e:Math.abs(i.x_m-e.x_m)<rf&&Math.abs(i.y_m-e.y_m)<rf&&Math.abs(i.z_m-e.z_m)<rf&&Math.abs(i.roll_rad-e.roll_rad)<Og&&Math.abs(i.pitch_rad-e.pitch_rad)<Og&&Math.abs(i.yaw_rad-e.yaw_rad)<Og}var vw=.12,hI=.02;function uI(i,e,t){let n=i.max_x-i.min_x+2*vw,s=i.max_y-i.min_y+2*vw,r=Math.min(e/n,t/s);return{scale:r,left:e/2-r*(i.min_x+i.max_x)/2,top:t/2+r*(i.min_y+i.max_y)/2}}var is=class{element=document.createElement("canvas");ground=document.createElement("canvas");visible={model:!0,odometry:!0,fused:!0,truth:!0};course;frame;projection={scale:100,left:0,top:0};ratio=1;moved=new Ea;setCourse(e,t){this.course=e,this.frame=t,this.paintGround()}setCamera(e){this.moved.reset()}show(e,t){this.visible[e]=t,this.moved.reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.ratio=Math.min(window.devicePixelRatio,2),this.element.width=this.ground.width=Math.round(e*this.ratio),this.element.height=this.ground.height=Math.round(t*this.ratio),this.paintGround())}draw(e){let t=e.get("/estimate"),n=this.element.getContext("2d");if(n===null||!this.moved.check(e))return;n.setTransform(1,0,0,1,0,0),n.drawImage(this.ground,0,0);for(let r of oi){if(!this.visible[r])continue;let o=e.path_histories[r].coordinates;n.strokeStyle=rt(r),n.lineWidth=2*this.ratio,n.lineJoin="round",n.beginPath();for(let a=0;a<o.length;a+=3){let l=this.pixel(o[a]??0,o[a+1]??0);n.lineTo(l.x,l.y)}n.stroke()}if(t===void 0)return;for(let r of oi){let o=t[r];!o||r===t.steering||!this.visible[r]||(this.polygon(n,Ks(dI(o),this.shape.length_m,this.shape.width_m)),n.strokeStyle=rt(r),n.lineWidth=1.5*this.ratio,n.stroke())}for(let r of Gl)this.visible[r]&&this.uncertainty(n,r,t[r]);let s=t[t.steering];this.robot(n,s,e.leftTrack_m,e.rightTrack_m),this.element.dataset.robot=[s.x_m,s.y_m,s.z_m,s.yaw_rad].join(" ")}reset(){this.moved.reset()}dispose(){this.element.remove()}world(e){let{scale:t,left:n,top:s}=this.projection;return{x:(e.x*this.ratio-n)/t,y:(s-e.y*this.ratio)/t}}point(e){let{x:t,y:n}=this.pixel(e.x,e.y);return{x:t/this.ratio,y:n/this.ratio}}get shape(){return this.course?.robot??$r}pixel(e,t){let{scale:n,left:s,top:r}=this.projection;return{x:s+n*e,y:r-n*t}}polygon(e,t){e.beginPath();for(let{x:n,y:s}of t){let r=this.pixel(n,s);e.lineTo(r.x,r.y)}e.closePath()}uncertainty(e,t,{x_m:n,y_m:s,sd_x_m:r,sd_y_m:o}){if(typeof r!="number"||typeof o!="number")return;let a=this.pixel(n,s);e.beginPath(),e.ellipse(a.x,a.y,2*r*this.projection.scale,2*o*this.projection.scale,0,0,2*Math.PI),e.strokeStyle=rt(t),e.lineWidth=this.ratio,e.stroke(),this.element.dataset[`${t}Uncertainty`]=[2*r,2*o].join(" ")}robot(e,t,n,s){let{axle_spacing_m:r,wheel_radius_m:o,gauge_m:a,shoe_width_m:l}=this.shape,c=this.pixel(t.x_m,t.y_m);e.save(),e.translate(c.x,c.y),e.scale(this.projection.scale,-this.projection.scale),e.rotate(t.yaw_rad);let h=r+2*o;e.fillStyle="#c9d1da",e.fillRect(-.42*h,-(a-l)/2,.84*h,a-l),e.fillStyle="#fff3c4",e.fillRect(.42*h-.008,-.03,.008,.06);let u=ta(r,o),d=Math.round(u/hI);for(let[f,g]of[[1,n],[-1,s]]){let y=f*a/2-l/2;e.fillStyle="#05080b",e.fillRect(-h/2,y,h,l),e.fillStyle="#5b6672";for(let p=0;p<d;p++){let m=du(r,o,p*u/d-g);m.y>o&&e.fillRect(m.x-.003,y,.006,l)}}e.restore()}paintGround(){let e=this.ground.getContext("2d");if(e===null)return;let{width:t,height:n}=this.ground;this.projection=uI(this.frame??xr(this.course),t,n),this.moved.reset(),e.fillStyle=rt("floor"),e.fillRect(0,0,t,n),this.grid(e);let s=this.course;if(s!==void 0){for(let r of s.surfaces)this.polygon(e,Ks(r,r.length_m,r.width_m)),e.fillStyle=rt("surface"),e.fill();e.strokeStyle=rt("obstacle-edge"),e.lineWidth=this.ratio;for(let r of s.ramps){this.polygon(e,Ks(r,na(r),r.width_m)),e.fillStyle=rt("obstacle"),e.fill(),e.stroke();let o=r.height_m/Math.tan(r.up_rad);for(let a of[o-na(r)/2,o+r.top_m-na(r)/2])this.across(e,r,a,r.width_m)}for(let r of s.blocks)this.polygon(e,Ks(r,r.depth_m,r.width_m)),e.fillStyle=rt("obstacle"),e.fill(),e.stroke();e.strokeStyle=rt("fence");for(let r of fu(s))this.polygon(e,r),e.fillStyle=rt("keep-out"),e.fill(),e.stroke();this.polygon(e,Cl(s)),e.stroke(),e.setLineDash([6*this.ratio,5*this.ratio]),e.strokeStyle=rt("path"),e.lineWidth=1.5*this.ratio,e.beginPath();for(let r of s.path){let o=this.pixel(r.x_m,r.y_m);e.lineTo(o.x,o.y)}e.stroke(),e.setLineDash([])}}across(e,t,n,s){let r=Math.cos(t.heading_rad),o=Math.sin(t.heading_rad);e.beginPath();for(let a of[-s/2,s/2]){let l=this.pixel(t.x_m+r*n-o*a,t.y_m+o*n+r*a);e.lineTo(l.x,l.y)}e.stroke()}grid(e){let{scale:t,left:n,top:s}=this.projection,{width:r,height:o}=this.ground,a=.1;e.lineWidth=1;let l=(c,h,u,d,f)=>{e.strokeStyle=c?rt("grid-bold"):rt("grid"),e.beginPath(),e.moveTo(Math.round(h)+.5,Math.round(u)+.5),e.lineTo(Math.round(d)+.5,Math.round(f)+.5),e.stroke()};for(let c=Math.ceil(-n/t/a);c*a*t+n<r;c++)l(c%5===0,n+c*a*t,0,n+c*a*t,o);for(let c=Math.ceil((s-o)/t/a);c*a*t<s;c++)l(c%5===0,0,s-c*a*t,r,s-c*a*t)}},dI=i=>({x_m:i.x_m,y_m:i.y_m,heading_rad:i.yaw_rad});var Aa=class{constructor(e,t,n,s){this.capacity=e;this.width_m=n;this.lift_m=s;this.vertices=new Float32Array(6*e),this.attribute=new Vn(this.vertices,3),this.indices=new Uint32Array(6*e);for(let a=0;a+1<e;a++)this.indices.set(yw(a),6*a);let r=new An;r.setAttribute("position",this.attribute),r.setIndex(new Vn(this.indices,1)),r.setDrawRange(0,0);let o=new hr({color:t,side:hi,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-4});this.mesh=new nn(r,o),this.mesh.frustumCulled=!1}capacity;width_m;lift_m;mesh;vertices;attribute;indices;shown=0;generation=-1;follow(e){if(e.generation===this.generation&&e.length===this.shown)return!1;let t=e.generation===this.generation?Math.max(this.shown-1,0):0;return this.generation=e.generation,this.show(e.coordinates,t),!0}set(e,t=0){let n=Math.min(e.length/3,this.capacity);for(let r=0;r+1<this.capacity;r++){let o=t>0&&Math.floor(r/t)%2===1;this.indices.set(o?[0,0,0,0,0,0]:yw(r),6*r)}let s=this.mesh.geometry.getIndex();s!==null&&(s.needsUpdate=!0),this.show(e.subarray(0,3*n),0)}reset(){this.generation=-1}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}show(e,t){let n=e.length/3;Tv(e,t,n,this.width_m,this.lift_m,this.vertices),this.attribute.clearUpdateRanges(),n>t&&this.attribute.addUpdateRange(6*t,6*(n-t)),this.attribute.needsUpdate=!0,this.mesh.geometry.setDrawRange(0,6*Math.max(n-1,0)),this.shown=n}},yw=i=>[2*i,2*i+1,2*i+2,2*i+1,2*i+3,2*i+2];var xw=1.2,fI=.006,pI=5,of=class{group=new Di;path;set(e){if(this.path?.dispose(),this.path=void 0,Pl(this.group),this.floor(e),e!==void 0){for(let t of e.surfaces){let n=new nn(new vs(t.length_m,t.width_m),new Yi({color:rt("surface"),polygonOffset:!0,polygonOffsetFactor:-1}));n.receiveShadow=!0,Ug(n,t),n.position.z=6e-4,this.group.add(n)}for(let t of e.ramps){let n=Xr(sm(t),t.width_m,rt("obstacle"),rt("obstacle-edge"));Ug(n,t),this.group.add(n)}for(let t of e.blocks){let n=Xr(wv(t),t.width_m,rt("obstacle"),rt("obstacle-edge"));Ug(n,t),this.group.add(n)}for(let t of[Cl(e),...fu(e)]){let n=t.flatMap(({x:s,y:r})=>[s,r,.001]);n.length>0&&this.group.add(new Ur(Fg(n),new Si({color:rt("fence")})))}if(e.path.length>1){let t=Mv(e);this.path=new Aa(t.length/3,rt("path"),fI,.0015),this.path.set(t,pI),this.group.add(this.path.mesh,bw(e.path[0],.014,.02),bw(e.path.at(-1),.02,.03))}}}floor(e){let t=xr(e),n=.1,s=y=>Math.floor((y-xw)/n)*n,r=y=>Math.ceil((y+xw)/n)*n,[o,a,l,c]=[s(t.min_x),r(t.max_x),s(t.min_y),r(t.max_y)],h=new nn(new vs(40,40),new Yi({color:rt("floor"),polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}));h.position.set((o+a)/2,(l+c)/2,0),h.receiveShadow=!0;let u=[],d=[],f=(y,p,m)=>{for(let b=Math.round(y/n);b<=Math.round(p/n);b++)(b%5===0?d:u).push(...m(b*n))},g=(y,p,m)=>{let b=[];for(let C=Math.round(y/n);C<Math.round(p/n);C+=5)b.push(...m(C*n,Math.min((C+5)*n,p)));return b};f(o,a,y=>g(l,c,(p,m)=>[y,p,0,y,m,0])),f(l,c,y=>g(o,a,(p,m)=>[p,y,0,m,y,0])),this.group.add(h,new _s(Fg(u),new Si({color:rt("grid")})),new _s(Fg(d),new Si({color:rt("grid-bold")})))}};function Ug(i,e){i.position.set(e.x_m,e.y_m,0),i.rotation.z=e.heading_rad}function Fg(i){let e=new An;return e.setAttribute("position",new Vn(new Float32Array(i),3)),e}function bw(i,e,t){let n=new nn(new cl(e,t,32),new hr({color:rt("path"),side:hi,polygonOffset:!0,polygonOffsetFactor:-2}));return n.position.set(i?.x_m??0,i?.y_m??0,.001),n}var af=class{drawn_ms=-1/0;free_ms=-1/0;slow=0;waiting=!1;level=0;tick(e){if(this.waiting){this.waiting=!1;let t=e-this.drawn_ms;this.free_ms=t>45?e+t*(1/.5-1):-1/0,this.slow=t>45?this.slow+1:Math.max(0,this.slow-1),this.slow>40&&this.level<2&&(this.level++,this.slow=0)}return e>=this.free_ms}drawn(e){this.drawn_ms=e,this.waiting=!0}};var mI=.007,gI={model:.002,odometry:.0025,fused:.003,truth:.0035},_I=2,lf=class{element;renderer;scene=new tl;rig;sun=new ml("#ffffff",2.2);course=new of;ribbons;ghosts;robot;rings=Gl.map(e=>({name:e,ring:new pu(rt(e))}));shape=$r;visible={model:!0,odometry:!0,fused:!0,truth:!0};pace=new af;level=0;lag_s=0;moved=new Ea;changed=!0;constructor(e,t){this.renderer=new lu({antialias:!0,powerPreference:"low-power"}),this.element=this.renderer.domElement,this.element.addEventListener("webglcontextlost",t),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Br,this.scene.background=new ft(rt("sky")),this.scene.fog=new el(rt("sky"),3.5,9),this.scene.add(new dl("#bcd6f5","#26303c",1.4),this.sun,this.sun.target,this.course.group);for(let{ring:n}of this.rings)this.scene.add(n.line);this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.002,this.rig=new sf(this.element,e),this.ribbons=ww(n=>new Aa(4e3,rt(n),mI,gI[n]));for(let n of oi)this.scene.add(this.ribbons[n].mesh);this.robot=new Rl(this.shape),this.ghosts=this.makeGhosts(),this.scene.add(this.robot.group),this.setCourse(void 0)}setCourse(e){this.course.set(e);let t=xr(e);this.rig.frame(t);let n=(t.min_x+t.max_x)/2,s=(t.min_y+t.max_y)/2,r=Math.hypot(t.max_x-t.min_x,t.max_y-t.min_y)/2+.2;this.sun.target.position.set(n,s,0),this.sun.position.set(n-.6*r,s-.35*r,1.4*r);let o=this.sun.shadow.camera;if([o.left,o.right,o.bottom,o.top]=[-r,r,-r,r],[o.near,o.far]=[.1,4*r],o.updateProjectionMatrix(),e!==void 0&&JSON.stringify(e.robot)!==JSON.stringify(this.shape)){this.shape=e.robot;for(let a of[this.robot,...Object.values(this.ghosts)])this.scene.remove(a.group),Pl(a.group);this.robot=new Rl(this.shape),this.scene.add(this.robot.group),this.ghosts=this.makeGhosts()}this.moved.reset(),this.changed=!0}setCamera(e){this.rig.set(e),this.changed=!0}show(e,t){this.visible[e]=t,this.moved.reset()}draw(e,t){let n=performance.now();if(this.lag_s+=t,!this.pace.tick(n))return;this.degrade();for(let l of oi){let c=this.ribbons[l];c.follow(e.path_histories[l])&&(this.changed=!0),c.mesh.visible=this.visible[l]}let s=e.get("/estimate");if(this.moved.check(e)){this.changed=!0,this.robot.group.visible=s!==void 0,s!==void 0&&this.robot.set(s[s.steering],e.leftTrack_m,e.rightTrack_m);for(let{name:l,ring:c}of this.rings)s!==void 0&&this.visible[l]?c.set(s[l]):c.line.visible=!1;for(let l of oi){let c=s?.[l],h=this.ghosts[l];h.group.visible=!!c&&l!==s.steering&&this.visible[l],c&&h.set(c)}}let r=this.rig.update(e.pose,this.lag_s);if(this.lag_s=0,!r&&!this.changed)return;this.changed=!1,this.renderer.render(this.scene,this.rig.camera),this.pace.drawn(n);let{position:o,rotation:a}=this.robot.group;s!==void 0&&(this.element.dataset.robot=[o.x,o.y,o.z,a.z].join(" "))}reset(){this.moved.reset();for(let e of oi)this.ribbons[e].reset()}resize(){let{clientWidth:e,clientHeight:t}=this.element.parentElement??this.element;e===0||t===0||(this.renderer.setPixelRatio(this.level>1?.6:Math.min(window.devicePixelRatio,_I)),this.renderer.setSize(e,t),this.rig.resize(e/t),this.changed=!0)}dispose(){Pl(this.scene),this.renderer.dispose(),this.element.remove()}degrade(){this.pace.level!==this.level&&(this.level=this.pace.level,this.sun.castShadow=!1,this.level>1&&this.resize())}makeGhosts(){return ww(e=>{let t=new mu(this.shape,rt(e));return t.group.visible=!1,this.scene.add(t.group),t})}};function ww(i){return{model:i("model"),odometry:i("odometry"),fused:i("fused"),truth:i("truth")}}var cf=[...Ng,"map"],hf=class{element=x("section",{class:"viewport","aria-label":"Course"});stage=x("div",{class:"stage"});buttons=new Map;toggles=new Map;hidden=new Set;view;mode="free";webgl=!0;course;courseShown=-1;drafted=!1;frame;constructor(){let e=x("div",{class:"modes",role:"group","aria-label":"Camera"});for(let o of cf){let a=x("button",{type:"button","aria-pressed":"false",id:`camera-${o}`},o);a.addEventListener("click",()=>{this.set(o)}),this.buttons.set(o,a),e.append(a)}let t=x("div",{class:"key",role:"group","aria-label":"Paths"}),n=x("i",{class:"swatch dashed"});n.style.color="var(--path)",t.append(x("span",{class:"key-item"},n,"plan"));for(let o of oi){let a=x("i",{class:"swatch"});a.style.color=`var(--${o})`;let l=x("button",{type:"button",class:"key-item","aria-pressed":"true",id:`show-${o}`},a,o);l.addEventListener("click",()=>{this.toggle(o)}),this.toggles.set(o,l),t.append(l)}this.element.append(this.stage,t,e);let s=vI();s==="nothing"&&this.withoutWebgl();let r=s==="card"?"free":"map";this.view=this.make(r),this.set(this.view instanceof is?"map":r),new ResizeObserver(()=>{this.view.resize()}).observe(this.stage)}set(e){if(e!=="map"&&!this.webgl)return;this.view instanceof is!==(e==="map")&&(this.view.dispose(),this.view=this.make(e)),this.mode=this.view instanceof is?"map":e,this.mode!=="map"&&this.view.setCamera(this.mode),this.mark()}recolour(){this.view.dispose(),this.view=this.make(this.mode),this.mode!=="map"&&this.view.setCamera(this.mode)}next(){let e=this.webgl?cf:["map"];this.set(e[(e.indexOf(this.mode)+1)%e.length]??"map")}world(e){return this.view instanceof is?this.view.world(e):void 0}pixel(e){return this.view instanceof is?this.view.point(e):void 0}draft(e,t){this.drafted=e!==void 0,this.frame=t,e===void 0?this.courseShown=-1:this.setCourse(e)}setCourse(e){this.course=e,this.view instanceof is?this.view.setCourse(e,this.frame):this.view.setCourse(e)}draw(e,t){let n=e.received["/course"]??0;n!==this.courseShown&&!this.drafted&&(this.courseShown=n,this.setCourse(e.get("/course")));let s=this.toggles.get("truth");s&&dt(s,"absent",!e.get("/estimate")?.truth),dt(this.element,"stale",e.stale("/estimate")),this.view.draw(e,t)}reset(){this.courseShown=-1,this.view.reset()}toggle(e){this.hidden.delete(e)||this.hidden.add(e);let t=!this.hidden.has(e);this.view.show(e,t);let n=this.toggles.get(e);n&&$e(n,"aria-pressed",String(t))}make(e){let t=this.scene(e)??new is;this.stage.replaceChildren(t.element),t.element.setAttribute("aria-hidden","true"),t.resize(),t instanceof is?t.setCourse(this.course,this.frame):t.setCourse(this.course);for(let n of this.hidden)t.show(n,!1);return t}scene(e){if(!(e==="map"||!this.webgl))try{return new lf(()=>{this.mode="free",this.mark()},()=>{this.withoutWebgl(),this.set("map")})}catch{this.withoutWebgl();return}}withoutWebgl(){this.webgl=!1;for(let e of Ng){let t=this.buttons.get(e);t!==void 0&&(t.disabled=!0,t.title="This browser has no WebGL")}}mark(){for(let[e,t]of this.buttons)$e(t,"aria-pressed",String(e===this.mode))}};function vI(){let i=document.createElement("canvas").getContext("webgl2");if(i===null)return"nothing";let e=i.getExtension("WEBGL_debug_renderer_info"),t=String(i.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)?"processor":"card"}var uf=class{constructor(e,t){this.frames=e;this.store=t;this.begin_s=e.find(n=>n.topic==="/estimate")?.time_s??0,this.end_s=e.at(-1)?.time_s??0,this.at_s=this.begin_s,this.seek(this.begin_s)}frames;store;begin_s;end_s;playing=!1;speed=1;next=0;at_s;get duration_s(){return this.end_s-this.begin_s}get position_s(){return this.at_s-this.begin_s}get began_unix_s(){let e=this.frames.find(n=>n.topic==="/estimate"),t=(e?.time_s??0)-(e?.message?.t_s??0);return t>1e9?t:void 0}seek(e){let t=Math.min(Math.max(e,this.begin_s),this.end_s);t<this.at_s&&(this.next=0,this.store.clear()),this.at_s=t;for(let n=this.frames[this.next];n!==void 0&&n.time_s<=t;n=this.frames[++this.next])this.store.receive(n.topic,n.message)}show(e){this.seek(this.begin_s+e)}tick(e){if(this.playing){if(this.at_s>=this.end_s){this.playing=!1;return}this.seek(this.at_s+e*this.speed)}}toggle(){!this.playing&&this.at_s>=this.end_s&&this.seek(this.begin_s),this.playing=!this.playing}};var yI=ArrayBuffer,dn=Uint8Array,df=Uint16Array,xI=Int16Array;var ff=Int32Array,Bg=function(i,e,t){if(dn.prototype.slice)return dn.prototype.slice.call(i,e,t);(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length);var n=new dn(t-e);return n.set(i.subarray(e,t)),n},ic=function(i,e,t,n){if(dn.prototype.fill)return dn.prototype.fill.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;++t)i[t]=e;return i},bI=function(i,e,t,n){if(dn.prototype.copyWithin)return dn.prototype.copyWithin.call(i,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>i.length)&&(n=i.length);t<n;)i[e++]=i[t++]};var wI=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],Sn=function(i,e,t){var n=new Error(e||wI[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Sn),!t)throw n;return n},Sw=function(i,e,t){for(var n=0,s=0;n<t;++n)s|=i[e++]<<(n<<3);return s},SI=function(i,e){return(i[e]|i[e+1]<<8|i[e+2]<<16|i[e+3]<<24)>>>0},MI=function(i,e){var t=i[0]|i[1]<<8|i[2]<<16;if(t==3126568&&i[3]==253){var n=i[4],s=n>>5&1,r=n>>2&1,o=n&3,a=n>>6;n&8&&Sn(0);var l=6-s,c=o==3?4:o,h=Sw(i,l,c);l+=c;var u=a?1<<a:s,d=Sw(i,l,u)+(a==1&&256),f=d;if(!s){var g=1<<10+(i[5]>>3);f=g+(g>>3)*(i[5]&7)}f>2145386496&&Sn(1);var y=new dn((e==1?d||f:e?0:f)+12);return y[0]=1,y[4]=4,y[8]=8,{b:l+u,y:0,l:0,d:h,w:e&&e!=1?e:y.subarray(12),e:f,o:new ff(y.buffer,0,3),u:d,c:r,m:Math.min(131072,f)}}else if((t>>4|i[3]<<20)==25481893)return SI(i,4)+8;Sn(0)},oo=function(i){for(var e=0;1<<e<=i;++e);return e-1},sc=function(i,e,t){var n=(e<<3)+4,s=(i[e]&15)+5;s>t&&Sn(3);for(var r=1<<s,o=r,a=-1,l=-1,c=-1,h=r,u=new yI(512+(r<<2)),d=new xI(u,0,256),f=new df(u,0,256),g=new df(u,512,r),y=512+(r<<1),p=new dn(u,y,r),m=new dn(u,y+r);a<255&&o>0;){var b=oo(o+1),C=n>>3,T=(1<<b+1)-1,R=(i[C]|i[C+1]<<8|i[C+2]<<16)>>(n&7)&T,E=(1<<b)-1,v=T-o-1,A=R&E;if(A<v?(n+=b,R=A):(n+=b+1,R>E&&(R-=v)),d[++a]=--R,R==-1?(o+=R,p[--h]=a):o-=R,!R)do{var z=n>>3;l=(i[z]|i[z+1]<<8)>>(n&7)&3,n+=2,a+=l}while(l==3)}(a>255||o)&&Sn(0);for(var N=0,D=(r>>1)+(r>>3)+3,W=r-1,G=0;G<=a;++G){var I=d[G];if(I<1){f[G]=-I;continue}for(c=0;c<I;++c){p[N]=G;do N=N+D&W;while(N>=h)}}for(N&&Sn(0),c=0;c<r;++c){var F=f[p[c]]++,$=m[c]=s-oo(F);g[c]=(F<<$)-r}return[n+7>>3,{b:s,s:p,n:m,t:g}]},TI=function(i,e){var t=0,n=-1,s=new dn(292),r=i[e],o=s.subarray(0,256),a=s.subarray(256,268),l=new df(s.buffer,268);if(r<128){var c=sc(i,e+1,6),h=c[0],u=c[1];e+=r;var d=h<<3,f=i[e];f||Sn(0);for(var g=0,y=0,p=u.b,m=p,b=(++e<<3)-8+oo(f);b-=p,!(b<d);){var C=b>>3;if(g+=(i[C]|i[C+1]<<8)>>(b&7)&(1<<p)-1,o[++n]=u.s[g],b-=m,b<d)break;C=b>>3,y+=(i[C]|i[C+1]<<8)>>(b&7)&(1<<m)-1,o[++n]=u.s[y],p=u.n[g],g=u.t[g],m=u.n[y],y=u.t[y]}++n>255&&Sn(0)}else{for(n=r-127;t<n;t+=2){var T=i[++e];o[t]=T>>4,o[t+1]=T&15}++e}var R=0;for(t=0;t<n;++t){var E=o[t];E>11&&Sn(0),R+=E&&1<<E-1}var v=oo(R)+1,A=1<<v,z=A-R;for(z&z-1&&Sn(0),o[n++]=oo(z)+1,t=0;t<n;++t){var E=o[t];++a[o[t]=E&&v+1-E]}var N=new dn(A<<1),D=N.subarray(0,A),W=N.subarray(A);for(l[v]=0,t=v;t>0;--t){var G=l[t];ic(W,t,G,l[t-1]=G+a[t]*(1<<v-t))}for(l[0]!=A&&Sn(0),t=0;t<n;++t){var I=o[t];if(I){var F=l[I];ic(D,t,F,l[I]=F+(1<<v-I))}}return[e,{n:W,b:v,s:D}]},EI=sc(new dn([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],AI=sc(new dn([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],CI=sc(new dn([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],Mw=function(i,e){for(var t=i.length,n=new ff(t),s=0;s<t;++s)n[s]=e,e+=1<<i[s];return n},zg=new dn(new ff([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),PI=Mw(zg,0),Vg=new dn(new ff([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),RI=Mw(Vg,3),nc=function(i,e,t){var n=i.length,s=e.length,r=i[n-1],o=(1<<t.b)-1,a=-t.b;r||Sn(0);for(var l=0,c=t.b,h=(n<<3)-8+oo(r)-c,u=-1;h>a&&u<s;){var d=h>>3,f=(i[d]|i[d+1]<<8|i[d+2]<<16)>>(h&7);l=(l<<c|f)&o,e[++u]=t.s[l],h-=c=t.n[l]}(h!=a||u+1!=s)&&Sn(0)},LI=function(i,e,t){var n=6,s=e.length,r=s+3>>2,o=r<<1,a=r+o;nc(i.subarray(n,n+=i[0]|i[1]<<8),e.subarray(0,r),t),nc(i.subarray(n,n+=i[2]|i[3]<<8),e.subarray(r,o),t),nc(i.subarray(n,n+=i[4]|i[5]<<8),e.subarray(o,a),t),nc(i.subarray(n),e.subarray(a),t)},II=function(i,e,t){var n,s=e.b,r=i[s],o=r>>1&3;e.l=r&1;var a=r>>3|i[s+1]<<5|i[s+2]<<13,l=(s+=3)+a;if(o==1)return s>=i.length?void 0:(e.b=s+1,t?(ic(t,i[s],e.y,e.y+=a),t):ic(new dn(a),i[s]));if(!(l>i.length)){if(o==0)return e.b=l,t?(t.set(i.subarray(s,l),e.y),e.y+=a,t):Bg(i,s,l);if(o==2){var c=i[s],h=c&3,u=c>>2&3,d=c>>4,f=0,g=0;h<2?u&1?d|=i[++s]<<4|(u&2&&i[++s]<<12):d=c>>3:(g=u,u<2?(d|=(i[++s]&63)<<4,f=i[s]>>6|i[++s]<<2):u==2?(d|=i[++s]<<4|(i[++s]&3)<<12,f=i[s]>>2|i[++s]<<6):(d|=i[++s]<<4|(i[++s]&63)<<12,f=i[s]>>6|i[++s]<<2|i[++s]<<10)),++s;var y=t?t.subarray(e.y,e.y+e.m):new dn(e.m),p=y.length-d;if(h==0)y.set(i.subarray(s,s+=d),p);else if(h==1)ic(y,i[s++],p);else{var m=e.h;if(h==2){var b=TI(i,s);f+=s-(s=b[0]),e.h=m=b[1]}else m||Sn(0);(g?LI:nc)(i.subarray(s,s+=f),y.subarray(p),m)}var C=i[s++];if(C){C==255?C=(i[s++]|i[s++]<<8)+32512:C>127&&(C=C-128<<8|i[s++]);var T=i[s++];T&3&&Sn(0);for(var R=[AI,CI,EI],E=2;E>-1;--E){var v=T>>(E<<1)+2&3;if(v==1){var A=new dn([0,0,i[s++]]);R[E]={s:A.subarray(2,3),n:A.subarray(0,1),t:new df(A.buffer,0,1),b:0}}else v==2?(n=sc(i,s,9-(E&1)),s=n[0],R[E]=n[1]):v==3&&(e.t||Sn(0),R[E]=e.t[E])}var z=e.t=R,N=z[0],D=z[1],W=z[2],G=i[l-1];G||Sn(0);var I=(l<<3)-8+oo(G)-W.b,F=I>>3,$=0,V=(i[F]|i[F+1]<<8)>>(I&7)&(1<<W.b)-1;F=(I-=D.b)>>3;var le=(i[F]|i[F+1]<<8)>>(I&7)&(1<<D.b)-1;F=(I-=N.b)>>3;var Z=(i[F]|i[F+1]<<8)>>(I&7)&(1<<N.b)-1;for(++C;--C;){var Q=W.s[V],ie=W.n[V],de=N.s[Z],ue=N.n[Z],ee=D.s[le],me=D.n[le];F=(I-=ee)>>3;var ge=1<<ee,ve=ge+((i[F]|i[F+1]<<8|i[F+2]<<16|i[F+3]<<24)>>>(I&7)&ge-1);F=(I-=Vg[de])>>3;var _e=RI[de]+((i[F]|i[F+1]<<8|i[F+2]<<16)>>(I&7)&(1<<Vg[de])-1);F=(I-=zg[Q])>>3;var Ge=PI[Q]+((i[F]|i[F+1]<<8|i[F+2]<<16)>>(I&7)&(1<<zg[Q])-1);if(F=(I-=ie)>>3,V=W.t[V]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<ie)-1),F=(I-=ue)>>3,Z=N.t[Z]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<ue)-1),F=(I-=me)>>3,le=D.t[le]+((i[F]|i[F+1]<<8)>>(I&7)&(1<<me)-1),ve>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=ve-=3;else{var Je=ve-(Ge!=0);Je?(ve=Je==3?e.o[0]-1:e.o[Je],Je>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=ve):ve=e.o[0]}for(var E=0;E<Ge;++E)y[$+E]=y[p+E];$+=Ge,p+=Ge;var Ue=$-ve;if(Ue<0){var ot=-Ue,ht=e.e+Ue;ot>_e&&(ot=_e);for(var E=0;E<ot;++E)y[$+E]=e.w[ht+E];$+=ot,_e-=ot,Ue=0}for(var E=0;E<_e;++E)y[$+E]=y[Ue+E];$+=_e}if($!=p)for(;p<y.length;)y[$++]=y[p++];else $=y.length;t?e.y+=$:y=Bg(y,0,$)}else if(t){if(e.y+=d,p)for(var E=0;E<d;++E)y[E]=y[p+E]}else p&&(y=Bg(y,p));return e.b=l,y}Sn(2)}},kI=function(i,e){if(i.length==1)return i[0];for(var t=new dn(e),n=0,s=0;n<i.length;++n){var r=i[n];t.set(r,s),s+=r.length}return t};function Tw(i,e){for(var t=[],n=+!e,s=0,r=0;i.length;){var o=MI(i,n||e);if(typeof o=="object"){for(n?(e=null,o.w.length==o.u&&(t.push(e=o.w),r+=o.u)):(t.push(e),o.e=0);!o.l;){var a=II(i,o,e);a||Sn(5),e?o.e=o.y:(t.push(a),r+=a.length,bI(o.w,0,a.length),o.w.set(a,o.w.length-a.length))}s=o.b+o.c*4}else s=o;i=i.subarray(s)}return kI(t,r)}var Hg=[137,77,67,65,80,48,13,10],rc={header:1,footer:2,schema:3,channel:4,message:5,chunk:6,dataEnd:15},Cs=9,Ew=64*1024*1024,pf=class{constructor(e,t=()=>!0){this.received=e;this.wanted=t}received;wanted;buffer=new Uint8Array(65536);begin=0;end=0;begun=!1;topics=new Map;ended=!1;push(e){if(!this.ended){if(this.append(e),!this.begun){if(this.end-this.begin<Hg.length)return;if(Hg.some((t,n)=>this.buffer[this.begin+n]!==t))throw new Error("not an MCAP file");this.begin+=Hg.length,this.begun=!0}for(;this.end-this.begin>=Cs;){let t=new DataView(this.buffer.buffer,this.begin,this.end-this.begin),n=Number(t.getBigUint64(1,!0));if(n>Ew)throw new Error("the recording is corrupted: a record of impossible length");if(t.byteLength<Cs+n)break;let s=this.buffer.subarray(this.begin+Cs,this.begin+Cs+n);this.begin+=Cs+n;let r=t.getUint8(0);if(r===rc.dataEnd||r===rc.footer){this.ended=!0;break}this.record(r,s)}}}append(e){let t=this.end-this.begin;if(this.end+e.length>this.buffer.length){let n=Math.max(this.buffer.length,t+e.length),s=n>this.buffer.length?new Uint8Array(2*n):this.buffer;s.set(this.buffer.subarray(this.begin,this.end)),this.buffer=s,this.begin=0,this.end=t}this.buffer.set(e,this.end),this.end+=e.length}record(e,t){let n=new DataView(t.buffer,t.byteOffset,t.byteLength);if(e===rc.channel&&t.length>=8)this.topics.set(n.getUint16(0,!0),Aw(t,n,4).text);else if(e===rc.message&&t.length>=22){let s=this.topics.get(n.getUint16(0,!0)),r=Number(n.getBigUint64(6,!0))*1e-9;s!==void 0&&this.wanted(s,r)&&this.received({topic:s,time_s:r,data:t.subarray(22)})}else e===rc.chunk&&t.length>=32&&this.chunk(t,n)}chunk(e,t){let n=Number(t.getBigUint64(16,!0));if(n>Ew)throw new Error("the recording is corrupted: a chunk of impossible length");let s=Aw(e,t,28),r=e.subarray(s.next+8),o=r;if(s.text==="zstd")o=Tw(r,new Uint8Array(n));else if(s.text!=="")throw new Error(`chunks compressed with "${s.text}" cannot be read here`);let a=0;for(;o.length-a>=Cs;){let l=new DataView(o.buffer,o.byteOffset+a),c=Number(l.getBigUint64(1,!0));if(c>o.length-a-Cs)throw new Error("the recording is corrupted: a chunk ends too early");this.record(l.getUint8(0),o.subarray(a+Cs,a+Cs+c)),a+=Cs+c}}},DI=new TextDecoder;function Aw(i,e,t){let n=e.getUint32(t,!0);if(n>i.length-t-4)throw new Error("the recording is corrupted: a text ends too early");return{text:DI.decode(i.subarray(t+4,t+4+n)),next:t+4+n}}var mf=class{constructor(e,t){this.capacity=e;this.interval_s=t}capacity;interval_s;items=[];wants(e){let t=this.items.at(-1);return t===void 0||e-t.time_s>=this.interval_s}add(e,t){if(this.wants(e)){if(this.items.length===this.capacity){for(let s=0;2*s<this.capacity;s++){let r=this.items[2*s];r!==void 0&&(this.items[s]=r)}this.items.length=Math.ceil(this.capacity/2);let n=(this.items.at(-1)?.time_s??0)-(this.items[0]?.time_s??0);if(this.interval_s=Math.max(2*this.interval_s,n/this.items.length),!this.wants(e))return}this.items.push({time_s:e,item:t})}}};var NI={"/course":[4,0],"/estimate":[2e4,.0199],"/slip":[8e3,.049],"/sample":[15e3,.0399],"/command":[15e3,.0399],"/state":[8e3,0],"/event":[2e3,0],"/link":[2e3,.19],"/loop":[2e3,.49],"/camera/image":[800,0]},Gg=class{topics=new Map;decoder=new TextDecoder;scanner;constructor(){for(let[e,[t,n]]of Object.entries(NI))this.topics.set(e,new mf(t,n));this.scanner=new pf(({topic:e,time_s:t,data:n})=>{try{this.topics.get(e)?.add(t,JSON.parse(this.decoder.decode(n)))}catch{}},(e,t)=>this.topics.get(e)?.wants(t)===!0)}push(e){this.scanner.push(e)}frames(){let e=[];for(let[t,n]of this.topics)for(let{time_s:s,item:r}of n.items)e.push({time_s:s,topic:t,message:r});return e.sort((t,n)=>t.time_s-n.time_s)}};async function Cw(i,e,t){let n=await fetch(i,{signal:t});if(!n.ok||n.body===null)throw new Error(`${i}: ${n.status} ${n.statusText}`);let s=Number(n.headers.get("Content-Length")??NaN),r=n.body.getReader(),o=new Gg,a=0;for(;;){let{done:c,value:h}=await r.read();if(c)break;a+=h.length,o.push(h),s>0&&e(a/s)}let l=o.frames();if(!l.some(c=>c.topic==="/estimate"))throw new Error("the recording holds no poses");return l}function Wg(i){return i instanceof HTMLElement&&i.matches("input:not([type=range]), select, textarea")}var Pw=i=>i.metaKey||i.key==="Meta";function Rw(i){window.addEventListener("keydown",e=>{if(e.key==="Escape"||e.code==="Space"&&!Wg(e.target)){e.preventDefault(),e.repeat||i.stop();return}if(Pw(e)&&i.letGo(),!(e.ctrlKey||e.metaKey||e.altKey||Wg(e.target))){if(i.driveKey(e.code,e.repeat?"repeated":"pressed")){e.preventDefault(),e.stopPropagation();return}e.key==="r"&&!e.repeat?i.start():e.key==="h"&&!e.repeat?i.hold():e.key==="p"&&!e.repeat?i.pause():e.key==="m"&&!e.repeat?i.drive():e.key==="c"?i.nextCamera():e.key>="1"&&e.key<="4"?i.camera(Number(e.key)-1):e.key==="?"?i.keys():e.key==="["?i.step(-1):e.key==="]"&&i.step(1)}},{capture:!0}),window.addEventListener("keyup",e=>{e.code==="Space"&&!Wg(e.target)&&e.preventDefault(),Pw(e)&&i.letGo(),i.driveKey(e.code,"released")},{capture:!0})}function Lw(i){let e=i.map(()=>0),t=n=>{i.forEach((s,r)=>{n<(e[r]??0)||(e[r]=n+s.period_ms,s.run(n))}),requestAnimationFrame(t)};requestAnimationFrame(t)}var Xg="tp100.theme",kw=matchMedia("(prefers-color-scheme: light)"),gf=()=>kw.matches?"light":"dark";function $g(){try{let i=localStorage.getItem(Xg);return i==="dark"||i==="light"?i:void 0}catch{return}}function OI(i){try{i===gf()?localStorage.removeItem(Xg):localStorage.setItem(Xg,i)}catch{}}var Iw=()=>document.documentElement.dataset.theme;function Dw(i){document.documentElement.dataset.theme=i,Zb(),document.querySelector('meta[name="theme-color"]')?.setAttribute("content",rt("panel"))}Dw($g()??gf());function Nw(i){let e=x("button",{type:"button",class:"theme-switch",title:"Light or dark page","aria-label":"Light page"},li("theme")),t=n=>{n!==Iw()&&(Dw(n),i()),$e(e,"aria-pressed",String(n==="light"))};return e.addEventListener("click",()=>{let n=Iw()==="light"?"dark":"light";OI(n),t(n)}),kw.addEventListener("change",()=>{t($g()??gf())}),t($g()??gf()),e}var UI=["/state","/course","/path_history","/estimate","/slip","/link","/loop","/event","/parameter","/recording","/client","/camera/image"],FI=100,BI=1e3/30-8,zI=100,VI=200,HI=60,GI=500,Mn=new Hl,Pi=Mn,ss,Zg,jg="",_f={},Hw=0,Gw=()=>Ky(`${location.origin}/`),Gn=new ha(Gw,{serverInfo:i=>{_f=i.metadata},ready:()=>{Pa.ready()},closed:i=>{Hw=performance.now()+i,Pa.button.disconnected(),js.forget("The connection was lost"),rs.lose("the connection to the daemon is lost")},status:(i,e)=>{i>0&&uo.say(e,performance.now())},parameters:()=>{}}),ho=(i,e)=>Gn.call(i,e),js=new Qu(ho),Pa=new Ku(Gn,Gw);function Ww(){js.forget("STOP was pressed"),Pa.press(performance.now()),yf.show(Pa.button.view(performance.now()))}async function Xw(i,e){Zg?.abort();let t=Zg=new AbortController;jg=e,lo.loading(e,0);try{let n=await Cw(i,s=>{lo.loading(e,s)},t.signal);ss=new uf(n,new Hl(()=>0)),lo.open(e,ss),co.look(ss.frames),$w(ss.store),ss.playing=!0}catch(n){if(t.signal.aborted)return;vf(),uo.say(Ot(n),performance.now())}}function vf(){Zg?.abort(),ss=void 0,jg="",lo.close(),co.look(void 0),$w(Mn)}function $w(i){Pi=i,document.body.classList.toggle("replaying",i!==Mn),bf.window_s=ss===void 0?HI:Math.min(Math.max(ss.duration_s,20),Hm),os.reset(),e0.reset(),t0.reset(),n0.reset()}function qw(){return ss===void 0?Number(_f.start_unix_ns??NaN)/1e9||void 0:ss.began_unix_s}function ao(){return _f.commands!=="stop"}function WI(i){i&&(vf(),os.set("map")),Sf.show(i),Ra.drawing(i)}function XI(i){i&&(vf(),Sf.show(!1),os.set("map")),Ra.element.hidden=i,document.body.classList.toggle("drawing",i)}var yf=new jd(Ww);yf.element.id="stop";var Ca=new nd(ho,js,i=>{uo.say(i,performance.now())}),Qg=new Xu(()=>navigator.getGamepads(),()=>performance.now()),rs=new Gu(ho,js.move,Qg,()=>document.visibilityState==="visible"&&document.hasFocus(),i=>{i!==""&&uo.say(`Driving by hand: ${i}`,performance.now())}),xf=new dd(rs,Qg,js),Yw=new Jd,uo=new Sd,os=new hf,Kw=new qd,e0=new ju,t0=new Qd,Zw=new Md,bf=new Xd,n0=new gd,Jw=new Ju(i=>{uo.say(i,performance.now())}),Ow=new md(Jw.elements),Jg=new $d((i,e)=>{Xw(i.url,e.run)},i=>Gn.call(i.name,i.request)),lo=new ef(vf),Uw=new Ad((i,e)=>{Gn.setParameter(i,e)},ho),co=new Zd(Vu),Fw=new wd,Bw=new ud(ho,js),zw=new yd(ho,js),jw=i=>Gn.call(i.name,i.request),wf=new Hu(os,jw,()=>Mn.get("/course")?.robot,XI),Ra=new rd(jw,WI,wf),$I=x("div",{},Ra.element,wf.element),Sf=new Cd(i=>os.world(i),()=>Mn.pose?.yaw_rad??0,i=>{Sf.show(!1),Ra.placed(i)}),Mf=new fd([{id:"events",title:"Events",element:Ow.element,show:()=>{Ow.show(Pi,qw())}},{id:"courses",title:"Courses",element:$I,show:()=>{Ra.show(Mn,Gn.ready,ao())}},{id:"runs",title:"Runs",element:Jg.element,show:()=>{Jg.show(Gn.ready&&ao(),jg)}},{id:"parameters",title:"Parameters",element:Uw.element,show:()=>{Uw.show(Mn,Gn.ready,ao())}},{id:"signals",title:"Signals",element:co.element,show:()=>{co.show(Pi)}},{id:"link",title:"Link",element:Fw.element,show:()=>{Fw.show(Pi)}},{id:"doctor",title:"Doctor",element:Bw.element,show:()=>{Bw.show(Mn,Gn.ready,ao())}},{id:"identify",title:"Identify",element:zw.element,show:()=>{zw.show(Mn,Gn.ready,ao())}},{id:"keys",title:"Keys",element:yx(),show:()=>{}}],Nw(()=>{os.recolour()})),Qw=new xd,qI=x("header",{class:"bar"},Qw.element,Yw.element,Ca.element,yf.element);bf.element.append(n0.element);Ca.element.append(xf.button);os.element.append(Kw.element,e0.element,wf.stage.element,Sf.element,xf.element,uo.element,lo.element,t0.element);document.body.append(qI,x("main",{},os.element,Zw.element,bf.element,Mf.element));for(let i of UI)Gn.subscribe(i,e=>{Mn.receive(i,e),co.receive(i,e),Jw.alerts.received(i,e,Mn),i==="/state"?(Pa.button.received(e.stop),js.received(e),rs.received(e)):i==="/recording"?Jg.changed():i==="/path_history"&&Gn.unsubscribe(i)});var qg=new URLSearchParams(location.hash.slice(1)).get("replay");qg!==null&&Xw(`/runs/${encodeURIComponent(qg)}/run.mcap`,qg);Promise.all([Vu("/estimate"),Vu("/slip")]).then(([i,e])=>{Mn.before(i,e)},()=>{});var YI=["/sample","/command"],Yg=new Set;function KI(){for(let i of YI){let e=Mf.selected==="signals"||co.needs(i);e!==Yg.has(i)&&(e?Gn.subscribe(i,t=>{co.receive(i,t)}):Gn.unsubscribe(i),e?Yg.add(i):Yg.delete(i))}}Rw({stop:Ww,start:()=>{Ca.pressStart()},hold:()=>{Ca.pressHold()},pause:()=>{Ca.pressPause()},drive:()=>{xf.press()},driveKey:ZI,letGo:()=>{rs.leave()},camera:i=>{os.set(cf[i]??"free")},nextCamera:()=>{os.next()},keys:()=>{Mf.select("keys")},step:i=>{lo.step(i)}});function ZI(i,e){if(!rs.drives&&e!=="released")return!1;let t=Qg.key(i,e)&&rs.drives;return t&&rs.tick(),t}setInterval(()=>{rs.tick()},Oy);for(let i of["blur","pagehide"])window.addEventListener(i,()=>{rs.leave()});document.addEventListener("visibilitychange",()=>{document.visibilityState!=="visible"&&rs.leave()});window.addEventListener("gamepaddisconnected",()=>{rs.tick()});var Kg=!1;setInterval(()=>{Kg||Mn.get("/state")?.watch!==!0||document.visibilityState!=="visible"||(Kg=!0,ho("watch",{}).catch(()=>{}).finally(()=>{Kg=!1}))},GI);var Vw=performance.now();Lw([{period_ms:0,run:()=>{yf.show(Pa.button.view(performance.now()))}},{period_ms:BI,run:JI},{period_ms:FI,run:()=>{Zw.show(Pi),t0.show(Pi),lo.show()}},{period_ms:zI,run:()=>{bf.show(Pi)}},{period_ms:VI,run:jI}]);function JI(i){let e=Math.min((i-Vw)/1e3,.5);Vw=i,ss?.tick(e),os.draw(Pi,e),e0.show(Pi,qw()),wf.tick(i,Ra.changeable)}function jI(i){Yw.show(Mn,Gn.ready),Kw.show(Pi,Pi!==Mn,i),Ca.show(Mn,Gn.ready,ao()),xf.show(Mn,Gn.ready,ao()),uo.show(Mn,Gn.ready,(Hw-i)/1e3,i,Pi!==Mn),n0.show(Pi),Mf.show(),KI(),Qw.show(Mn,_f),js.shown()}
