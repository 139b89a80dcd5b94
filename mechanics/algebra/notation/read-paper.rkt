#lang racket/base
;; Formulas as people type them at the prompt, read as S-expressions: by the grammar of
;; handwritten-formula.rkt, where next to nothing is known of names.
;;
;; Where that grammar finds two readings, there is none here; nor is there one of a text that may
;; mean another thing in another program (unread), or with a word that may be a product, as mgh.
;; Names stay as they are typed.

(require "handwritten-formula.rkt" "handwritten-words.rkt" "one-line-name.rkt" "paper-spelling.rkt"
         (only-in "name.rkt" Greek-name?)
         (only-in racket/list flatten remove-duplicates)
         (only-in racket/string string-split))

(provide read-paper as-typed)

;; known?   : symbol -> is it a name of the reader's, or of the library?
;; foreign? : symbol -> is it another program's name of something that is called otherwise here?
;; -> a datum, or #f
(define (read-paper text known? foreign?)
  (define plain (known-names-marked (plain-spelling text) known?))
  (define d
    (and (not (regexp-match? unread plain)) (not (stray-brace? plain))
         (or (known? 'e) (not (regexp-match? square-of-e plain)))
         (read-relation plain known?)))
  (and d
       (for/and ([s (in-list (flatten d))])
         (clear-name? s known? (lambda (s) (and (foreign? s) (before-operand? s plain)))))
       (own-operations (unmarked d) known?)))

;; 0 < x < 1; the grammar knows =.
(define (read-relation text known?)
  (define signs (remove-duplicates (regexp-match* #rx"[<>≤≥]" text)))
  (define parts
    (for/list ([part (if (null? signs) '() (string-split text (car signs) #:trim? #f))])
      (read-sides part known?)))
  (cond [(null? signs) (read-sides text known?)]
        [(and (andmap values parts) (not (regexp-match? #rx"=" text)) (null? (cdr signs)))
         (cons (cdr (assoc (car signs) '(("<" . <) (">" . >) ("≤" . <=) ("≥" . >=)))) parts)]
        [else #f]))

;; -> a datum, of an equation (= left right ...); or #f
(define (read-sides text known?)
  (let/ec return
    (define (none . _) (return #f))
    (define entries (read-handwritten text (names-alone text known?) none none))
    (cond [(or (pair? (cdr entries)) (ormap (lambda (s) (memq s '(= up))) (flatten entries))) #f]
          [(pair? (cdar entries)) (cons '= (car entries))]
          [else (caar entries)])))

(define (names-alone text known?)
  (define whole (regexp-match #px"^\\s*(\\p{L}[^\\s()]*)\\([^()]*\\)\\s*$" text))
  (vocabulary paper-name
              (lambda (s) (and (or (eq? s 'pi) (and (eq? s 'e) (known? s))) s))
              (lambda (s) (and whole (eq? s (paper-name (cadr whole))) (function-like? s)))
              (lambda (s dots) #f)
              (lambda (d) #f)))

;; f(x + 1), where it stands alone, not x(x - 1) or k(x - x0): a word, or a letter of functions
(define (function-like? s)
  (define text (symbol->string s))
  (or (memq s '(f F V U L H))
      (not (or (one-letter? (letters-of text)) (function-named text)))))

;; ---------------------------------------------------------------------------
;; Texts that are not read

(define unread
  (pregexp
   (string-append
    "[][;&$]|⟫\\(|\\\\math|[(]\\s*[+]"                     ; a[1], 'f(x), \mathrm{d}x, (+ x)
    "|(?<!\\p{L}|_)d\\s*(?:\\^?[²2])?\\s*\\p{L}*\\s*/\\s*d"   ; dx/dt
    "|\\{\\s*d(?!\\p{L})[^{}]*\\}\\s*\\{\\s*d(?!\\p{L})"      ; \frac{dx}{dt}
    "|['′]\\s*\\*|['′](?:\\p{L}|[0-9])"                    ; x' * y
    "|[+]-|[-+*/^]\\s*[+]"                                 ; x +- y
    "|(?<!\\p{L}|[0-9_.])[0-9.]+(?:[ij]|[eE](?![-+]?[0-9]))(?!\\p{L})" ; 2i
    "|[^0-9.\\s]\\s*(?:×|\\\\times(?![a-zA-Z]))\\s*[^0-9\\s]"  ; r × p
    "|(?:\\p{L}|_)[0-9]*/[0-9.]+\\s+(?:\\p{L}|[(])"        ; x/2 y
    "|(?<!\\p{L})[fF]\\s+\\(")))                           ; f (x + 1)

;; exp(2), or an eccentricity
(define square-of-e #px"(?<!\\p{L})e\\s*(?:\\^|\\*\\*)\\s*[0-9]|(?<!\\p{L})e²")

;; {x, y}, which belongs to no command, index or exponent
(define (stray-brace? text)
  (regexp-match? #rx"{" (regexp-replace* braces text "")))

(define braces #px"(?:\\\\[a-zA-Z]+\\s*(?:[0-9a-zA-Z]\\s*)?|[_^]\\s*|\\}\\s*)\\{")

;; ---------------------------------------------------------------------------
;; Names

;; theta-dot and x_1dot, if they are known, are ⟪theta-dot⟫ and ⟪x_1dot⟫ to the grammar; else a
;; hyphen may stand between letters for a sign.
(define (known-names-marked text known?)
  (define (marked name)
    (cond [(not (regexp-match? #px"-|_[0-9]+\\p{L}" name)) name]
          [(known? (string->symbol name)) (string-append "⟪" name "⟫")]
          [(andmap operand? (string-split name "-")) name]
          [else ";"]))
  (regexp-replace* whole-name text marked))

(define whole-name
  #px"(?<!\\p{L}|[0-9_.\\\\])\\p{L}(?:\\p{L}|[0-9_])*(?:-(?:\\p{L}|[0-9_])+)*")

(define (operand? text)
  (or (regexp-match? #rx"^[0-9]" text)
      (and (function-named text) #t)
      (and (one-letter? (letters-of text)) (not (regexp-match? #px"_[0-9]+\\p{L}" text)))))

(define (unmarked d)
  (define m (and (symbol? d) (regexp-match #px"^⟪(\\p{L}.*)⟫$" (symbol->string d))))
  (cond [(pair? d) (map unmarked d)]
        [m (string->symbol (cadr m))]
        [else d]))

;; ẋ is xdot; other letters stay, for the reader may have defined a value of that name.
(define (paper-name text)
  (cond [(member text '("π" "Pi")) 'pi]
        [(regexp-match? #px"[\u307\u308\u20DB]" (string-normalize-nfd text))
         (line-name->symbol text)]
        [else (string->symbol text)]))

;; Sum(x, i), grad f, but 1.5 kg
(define (before-operand? s text)
  (define name (regexp-quote (symbol->string s)))
  (regexp-match? (pregexp (string-append name "\\s*(?:[(0-9]|\\p{L})")) text))

(define (clear-name? d known? foreign?)
  (define text (if (symbol? d) (symbol->string d) ""))
  (cond [(not (regexp-match? #px"^\\p{L}" text)) #t]
        [(or (member text keywords) (foreign? d)) #f]
        [(or (memq d '(pi expt D)) (known? d) (function-named text)) #t]
        [else (not (or (regexp-match? odd-name text) (letters-in-a-row? text)))]))

(define odd-name #px"_$|[0-9]\\p{L}|(?!\\p{L}|\\p{M}|\\p{N})[^_]")

;; Words that are no names of quantities
(define keywords '("if" "else" "and" "or" "not" "lambda" "for" "in" "return" "def" "integral"
                   "times" "over" "plus" "minus" "half" "mod" "div" "squared"))

;; Is it rather a product or a call without its sign: mgh, omegat, sinx, pir, Dx?  A name has the
;; vowels of a word, or is a component or a difference, vx and dt.
(define (letters-in-a-row? text)
  (define letters (letters-of text))
  (define n (string-length letters))
  (cond [(or (one-letter? letters) (regexp-match? #px"^(?:[vF][xyz]|d[xyzrt]|kg)$" letters)) #f]
        [(regexp-match? #px"^(?:sin|cos|tan|exp|log|ln|sqrt|D)." text) (not (Greek-name? letters))]
        [(regexp-match? #px"^pi\\p{L}{1,2}$" letters) #t]
        [(Greek-beginning? letters) #t]
        [else (or (= n 2) (not (regexp-match? #px"^[a-zA-Z]*[aeiouAEIOU][a-zA-Z]*$" letters)))]))

(define (one-letter? letters) (or (= 1 (string-length letters)) (Greek-name? letters)))

(define (letters-of text)
  (define plain (regexp-replace* #px"\\p{M}" (string-normalize-nfd text) ""))
  (regexp-replace #rx"(.)(?:dot)+$" (car (regexp-match #px"^\\p{L}*" plain)) "\\1"))

;; theta and letters behind it; dots and digits may stand there.
(define (Greek-beginning? letters)
  (for/or ([n (in-range 3 (string-length letters))]) (Greek-name? (substring letters 0 n))))

;; ---------------------------------------------------------------------------
;; As one types it

;; Differences, and -x as (- x).
(define (as-typed d)
  (if (pair? d)
      (let ([d (map as-typed d)])
        (case (car d)
          [(+) (signed-sum (cdr d))]
          [(*) (if (negative? (cadr d)) (list '- (without-sign d)) d)]
          [else d]))
      d))

(define (signed-sum terms)
  (for/fold ([sum (car terms)]) ([t (in-list (cdr terms))])
    (cond [(negative? t) (list '- sum (- t))]
          [(and (pair? t) (eq? (car t) '-) (null? (cddr t))) (list '- sum (cadr t))]
          [(and (pair? sum) (eq? (car sum) '+)) (append sum (list t))]
          [else (list '+ sum t)])))

(define (negative? d) (and (real? d) (< d 0)))

;; (* -1 k x) -> (* k x)
(define (without-sign product)
  (define c (- (cadr product)))
  (define factors (if (eqv? c 1) (cddr product) (cons c (cddr product))))
  (if (null? (cdr factors)) (car factors) (cons '* factors)))
