#lang racket/base
;; Definitions as on paper: x = 3, f(x) = x^2, x(t) = A cos(omega t), L = 1/2 m v^2; and as in other
;; programs: def f(x): return x**2, f = lambda x: x**2, f = @(x) x.^2, f[x_] := x^2, m += 1.
;;
;; The formula behind the sign may have unknown letters.  Beside arguments they become parameters,
;; as the book writes them: ((x A omega) t).  Without arguments they are symbols; but a formula
;; with a t is a path, and one with a v and the name L, or a p and the name H, a function of the
;; state.

(require racket/list
         "prefix-form.rkt" "typed-text.rkt"
         "../written-form.rkt")

(provide definition-by-sign procedure-elsewhere state-by-sign)

;; forms : of a line; known? : symbol -> boolean -> the definition, a datum, or #f
(define (definition-by-sign forms known?)
  (define-values (text operands) (typed-text forms known?))
  (define word (and text (regexp-match by-word text)))
  (define plain (and text (plain-definition text word operands known?)))
  (if (and plain (not word))
      (with-letters (cadr plain) (caddr plain) known?)
      plain))

;; word : the parts of one that begins with `def`, or #f -> the same without a change for letters
(define (plain-definition text word operands known?)
  (define parts (or word (regexp-match by-sign text)))
  (define increment (regexp-match by-increment text))
  (define (defined head body)
    (define whole (procedure-parts head body))
    (define (known-here? name) (or (memq name (flatten (car whole))) (known? name)))
    (define value (text->prefix-form (cdr whole) operands known-here?))
    (and value
         (not (and (pair? value) (eq? (car value) '=)))
         (list 'define (car whole) value)))
  (cond [increment
         (defined (string->symbol (cadr increment)) (apply format "~a ~a (~a)" (cdr increment)))]
        [parts (defined (head-of (cadr parts) (or (caddr parts) (cadddr parts))) (last parts))]
        [else #f]))

(define head "(\\p{L}[^\\s()\\[=:+*/^<>,'²³⁴√·×]*)(?:\\(([^()]*)\\)|\\[([^][]*)\\])")
(define by-word
  (pregexp (format "^(?:def|define|let)\\s+~a\\s*[:=]*\\s*(?:return\\s+)?([^\\s=:].*)$" head)))
(define by-sign (pregexp (format "^(?:let[*]? |define )?\\s*~a?\\s*:?=(?!=)\\s*(.+)$" head)))
(define by-increment #px"^(\\p{L}[^\\s()=+*/-]*)\\s*([-+*/])=\\s*(.+)$")

(define (head-of name arguments)
  (define symbol (string->symbol name))
  (if arguments (cons symbol (names-in arguments)) symbol))

;; "x, y" and "x_"
(define (names-in text)
  (for/list ([name (in-list (regexp-match* #px"[^\\s,]+" text))])
    (string->symbol (regexp-replace #rx"_$" name ""))))

;; f and "lambda x: x^2" -> (f x) and "x^2"
(define (procedure-parts head body)
  (define found (regexp-match procedure body))
  (if found
      (cons (cons head (names-in (or (cadr found) (caddr found)))) (last found))
      (cons head body)))

(define procedure #px"^(?:(?:lambda|λ)\\s+([^:]*):|@\\s*\\(([^()]*)\\))\\s*(.+)$")

;; lambda x, y: x*y, or @(x, y) x.*y -> (lambda (x y) (* x y)), or #f
(define (procedure-elsewhere forms [known? (lambda (name) #f)])
  (define-values (text operands) (typed-text forms known?))
  (define parts (and text (regexp-match? procedure text) (procedure-parts 'lambda text)))
  (define (known-here? name) (or (memq name (car parts)) (known? name)))
  (define value (and parts (text->prefix-form (cdr parts) operands known-here?)))
  (and value (list 'lambda (cdar parts) value)))

;; ---------------------------------------------------------------------------
;; Letters

(define (with-letters head value known?)
  (define letters
    (filter (lambda (s) (not (or (and (known? s) (not (memq s names-of-operators)))
                                 (memq s (flatten head)))))
            (remove-duplicates (operands value))))
  (cond [(null? letters) (list 'define head value)]
        [(pair? head) (list 'define (cons (cons (car head) letters) (cdr head)) value)]
        [(rates-in head letters) => (lambda (rates) (function-of-state head letters rates value))]
        [(memq 't letters) (with-letters (list head 't) value known?)]
        [else (list 'define head (quoted value letters))]))

;; Names of the library that are letters of formulas: L = I omega.
(define names-of-operators '(I X))

(define (quoted d letters)
  (cond [(symbol? d) (if (memq d letters) (list 'quote d) d)]
        [(and (pair? d) (list? d) (not (eq? (car d) 'quote)))
         (cons (car d) (map (lambda (x) (quoted x letters)) (cdr d)))]
        [else d]))

;; ---------------------------------------------------------------------------
;; Lagrangians and Hamiltonians

;; v of L and p of H, or those of several coordinates, xdot and p_x; #f without any
(define (rates-in name letters)
  (define alone (case name [(L) 'v] [(H) 'p] [else #f]))
  (define marked (filter (lambda (s) (coordinate-of name s)) letters))
  (cond [(not alone) #f]
        [(memq alone letters) (list alone)]
        [(pair? marked) marked]
        [else #f]))

;; xdot of L, p_x of H -> x
(define (coordinate-of name letter)
  (define found
    (regexp-match (if (eq? name 'H) #px"^p_(.+)$" #px"^(.+)(?<!dot)dot$") (symbol->string letter)))
  (and found (string->symbol (cadr found))))

(define (function-of-state name letters rates value)
  (define coordinates
    (if (memq (car rates) '(v p))
        (list (or (findf (lambda (s) (memq s letters)) '(q x y z r theta)) 'q))
        (map (lambda (s) (coordinate-of name s)) rates)))
  (define (tuple make names) (if (null? (cdr names)) (car names) (cons make names)))
  (define state
    (list 'up 't (tuple 'up coordinates) (tuple (if (eq? name 'H) 'down 'up) rates)))
  `(define ((,name ,@(remove* (flatten state) letters)) ,state) ,value))

;; Of a definition that function-of-state made: the argument of its function; else #f
(define (state-by-sign form)
  (define head (cadr form))
  (and (pair? head) (pair? (car head))
       (pair? (cadr head)) (eq? (car (cadr head)) 'up)
       (case (caar head)
         [(L) "a Lagrangian is a function of (up t q v)"]
         [(H) "a Hamiltonian is a function of (up t q p)"]
         [else #f])))
